// The worker as a page uses it, and the programs that its answers are compared with.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { Worker } from "node:worker_threads";

const { ASV_ENGINE: engineFolder, ASV_PROGRAMS: programs, ASV_SOURCE: source } = process.env;

export const testcases = join(source, "testcases");

export class Engine {
  #worker = new Worker(join(engineFolder, "worker.js"));
  #open = new Map();
  #lastId = 0;
  ready;

  constructor() {
    this.ready = new Promise((resolve) => {
      this.#worker.on("message", (message) => {
        if (message.kind === "ready") return resolve(message);
        const { settle, onProgress } = this.#open.get(message.id);
        if (message.kind === "progress") return onProgress?.(message);
        this.#open.delete(message.id);
        return settle(message);
      });
    });
  }

  /** The answer to a message, an error too. */
  ask(kind, content = {}, onProgress = undefined) {
    const id = ++this.#lastId;
    return new Promise((settle) => {
      this.#open.set(id, { settle, onProgress });
      this.#worker.postMessage({ id, kind, ...content });
    });
  }

  /** A problem, or a scenario with whatever it may name of the files beside it. */
  async read(file) {
    const text = readFileSync(file, "utf8");
    const name = text.startsWith("{") && JSON.parse(text).map?.file;
    return this.ask("read", { name: file, text, files: name ? { [name]: readFileSync(join(dirname(file), name), "latin1") } : {} });
  }

  close() {
    return this.#worker.terminate();
  }
}

/** Runs a program; its output, or an exception where it fails. */
export function run(program, ...options) {
  return execFileSync(join(programs, program), options, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}

export function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
