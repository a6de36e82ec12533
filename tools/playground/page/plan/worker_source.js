// Workers of the text that lies in the page, so that they start without any request; first_worker.js has started the first.

/* global newWorker, firstWorker, engineBytes */

let first = firstWorker;

export function startWorker() {
  const worker = first ?? newWorker();
  if (worker !== first) worker.postMessage({ kind: "engine", bytes: engineBytes });
  first = null;
  return worker;
}
