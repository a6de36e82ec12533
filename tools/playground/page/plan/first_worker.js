// Runs while the rest of the page is still read, so that the engine starts meanwhile; worker_source.js takes over from here.

/** A worker of the text in the page. It says nothing but that it is ready, which is kept, until it is asked. */
function newWorker() {
  newWorker.source ??= URL.createObjectURL(new Blob([document.getElementById("worker").textContent], { type: "text/javascript" }));
  const worker = new Worker(newWorker.source);
  worker.onmessage = ({ data }) => { worker.ready = data; };
  return worker;
}

const firstWorker = newWorker();
