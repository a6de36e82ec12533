// The problem that is edited, with everything that was before it and can come back.

const mostKept = 200;

export class Model {
  constructor() {
    this.problem = null;
    this.version = 0;
    /** What is being edited: {kind: "box", index} or {kind: "start" | "goal"}, or null. */
    this.selection = null;
    this.name = "problem";
    this.past = [];
    this.future = [];
    this.held = null;
    this.listeners = [];
  }

  onChange(listener) {
    this.listeners.push(listener);
  }

  tell() {
    for (const listener of this.listeners) listener(this);
  }

  /** A new problem altogether: nothing to undo across it but the whole. */
  open(problem, name) {
    this.remember();
    this.problem = problem;
    this.name = name;
    this.selection = null;
    ++this.version;
    this.tell();
  }

  remember() {
    if (!this.problem) return;
    this.past.push({ problem: this.problem, name: this.name });
    if (this.past.length > mostKept) this.past.shift();
    this.future = [];
  }

  /** One edit: a function from a problem to the next one. Problems are never changed in place. */
  edit(change) {
    const next = change(this.problem);
    if (!next || next === this.problem) return;
    if (!this.held) this.remember();
    else if (!this.held.remembered) {
      this.held.remembered = true;
      this.remember();
    }
    this.problem = next;
    ++this.version;
    this.keepSelection();
    this.tell();
  }

  /** All edits of one drag are one step of undo. */
  hold() {
    this.held = { remembered: false };
  }

  release() {
    this.held = null;
    this.tell();
  }

  swap(from, to) {
    if (from.length === 0) return;
    to.push({ problem: this.problem, name: this.name });
    Object.assign(this, from.pop());
    ++this.version;
    this.keepSelection();
    this.tell();
  }

  undo() {
    this.swap(this.past, this.future);
  }

  redo() {
    this.swap(this.future, this.past);
  }

  select(selection) {
    this.selection = selection;
    this.tell();
  }

  keepSelection() {
    if (this.selection?.kind === "box" && this.selection.index >= this.boxes.length) this.selection = null;
  }

  get boxes() {
    return this.problem.obstacles ?? [];
  }
}
