// Questions to the worker, and its answers as promises. The messages are described in ../../worker.js.

export class Engine {
  /** start: makes a worker. */
  constructor(start) {
    this.start = start;
    this.nextId = 1;
    this.waiting = new Map();
    this.begin();
  }

  begin() {
    this.worker = this.start();
    this.ready = new Promise((resolve, reject) => {
      this.stopWaiting = resolve;
      this.worker.onmessage = ({ data }) => (data.kind === "ready" ? resolve(data) : this.answer(data));
      if (this.worker.ready) resolve(this.worker.ready);
      this.worker.onerror = (event) => reject(new Error(event.message || "the engine does not start"));
    });
  }

  /** Resolves when the worker of that moment, or the one that has come in its place, listens. */
  async whenReady() {
    let seen;
    do {
      seen = this.ready;
      await seen;
    } while (seen !== this.ready);
  }

  answer({ id, kind, ...answer }) {
    const question = this.waiting.get(id);
    if (!question) return;
    if (kind === "progress") {
      question.onProgress?.(answer);
      return;
    }
    this.waiting.delete(id);
    if (kind === "error") question.reject(Object.assign(new Error(answer.message), { line: answer.line, column: answer.column }));
    else question.resolve(answer);
  }

  ask(kind, fields = {}, onProgress = undefined) {
    const id = this.nextId++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, onProgress });
      this.worker.postMessage({ id, kind, ...fields });
    });
  }

  /** Ends whatever runs: what was asked is answered by "interrupted", and a new worker starts. */
  restart() {
    this.worker.terminate();
    const left = [...this.waiting.values()];
    this.waiting.clear();
    this.stopWaiting();
    this.begin();
    for (const question of left) question.resolve({ status: "interrupted" });
  }
}
