// Everything that the pointer does, by keys.

import { commands, fit, pan, stage, zoomCentre } from "player";
import { bendEnd, boundsOf, moveEnd, movedBox, putBox, removeBox, addBox, turnEnd, setCount } from "../model/edits.js";
import { keyStep } from "./handles.js";

const panPixels = 60;
const turnStep = Math.PI / 36;
const bendStep = 0.08;

const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const playbackKeys = { " ": "play", ArrowLeft: "step-back", ArrowRight: "step-on", Home: "to-start", End: "to-end" };

export class Keys {
  /** say(text): for those who hear the page. */
  constructor(model, editor, say) {
    Object.assign(this, { model, editor, say });
    document.addEventListener("keydown", (event) => {
      if (this.take(event)) event.preventDefault();
    });
  }

  take(event) {
    if (event.target.closest?.("dialog")) return false;
    if (event.ctrlKey || event.metaKey) return this.undoKey(event);
    if (event.altKey) return false;
    const inStage = event.target === stage;
    const inControl = event.target.closest?.("button, select, summary, input, textarea, a");
    if (inStage) return this.stageKey(event) || this.playKey(event);
    // A control keeps the keys that it has a use for; the bar understands all but the space itself.
    if (inControl && !(event.target.id === "scrub" && event.key === " ")) return false;
    return this.playKey(event);
  }

  undoKey(event) {
    if (event.target.closest?.("input, textarea, select") && event.target.id !== "scrub") return false;
    const key = event.key.toLowerCase();
    if (key === "z" && !event.shiftKey) this.model.undo();
    else if (key === "y" || (key === "z" && event.shiftKey)) this.model.redo();
    else return false;
    return true;
  }

  playKey(event) {
    const command = event.shiftKey ? null : playbackKeys[event.key];
    if (!command) return false;
    commands[command]();
    return true;
  }

  stageKey(event) {
    const { selection } = this.model;
    const arrow = arrows[event.key];
    if (arrow && selection) return this.moveSelection(arrow, event.shiftKey);
    if (arrow && event.shiftKey) return this.done(() => pan(-panPixels * arrow[0], panPixels * arrow[1]));
    const onStage = {
      "+": () => zoomCentre(1.5), "=": () => zoomCentre(1.5), "-": () => zoomCentre(1 / 1.5), "0": fit,
      ".": () => this.step(1), ",": () => this.step(-1), "b": () => this.newBox(), "s": () => this.choose({ kind: "start" }),
      "g": () => this.choose({ kind: "goal" }), "u": () => this.model.undo(), "r": () => this.model.redo(),
    };
    const onSelection = {
      Escape: () => this.model.select(null), Delete: () => this.remove(), Backspace: () => this.remove(),
      "[": () => this.shape(turnEnd, turnStep), "]": () => this.shape(turnEnd, -turnStep),
      "<": () => this.shape(bendEnd, -bendStep), ">": () => this.shape(bendEnd, bendStep),
      "a": () => this.count(1), "d": () => this.count(-1),
    };
    const action = onStage[event.key] ?? (selection ? onSelection[event.key] : undefined);
    return action ? this.done(action) : false;
  }

  done(action) {
    action();
    return true;
  }

  get things() {
    return [{ kind: "start" }, { kind: "goal" }, ...this.model.boxes.map((_, index) => ({ kind: "box", index }))];
  }

  step(direction) {
    const { things } = this;
    const { selection } = this.model;
    const at = selection ? things.findIndex(({ kind, index }) => kind === selection.kind && index === selection.index) : -1;
    const next = at < 0 ? (direction > 0 ? 0 : things.length - 1) : (at + direction + things.length) % things.length;
    this.choose(things[next]);
  }

  choose(selection) {
    this.model.select(selection);
    this.say(nameOf(selection));
  }

  /** Arrows move by a step of the grid; with Shift they resize a box at its upper right corner. */
  moveSelection([x, y], resize) {
    const { selection } = this.model;
    const step = keyStep(this.editor.grid);
    if (selection.kind !== "box") this.model.edit(moveEnd(selection.kind, x * step, y * step));
    else {
      const box = this.model.boxes[selection.index];
      const [low, high] = box;
      const grown = [low, [Math.max(high[0] + x * step, low[0] + step), Math.max(high[1] + y * step, low[1] + step)]];
      this.model.edit(putBox(selection.index, resize ? grown : movedBox(box, x * step, y * step)));
    }
    return true;
  }

  shape(edit, amount) {
    const { selection } = this.model;
    if (selection.kind !== "box") this.model.edit(edit(selection.kind, amount));
  }

  count(change) {
    const { problem } = this.model;
    this.model.edit(setCount(problem.start.length + change));
    if (problem.body.kind !== "point") this.say(`${this.model.problem.start.length} in the chain`);
  }

  /** A box in the middle of the field, of a fifth of its side. */
  newBox() {
    const [[lowX, lowY], [highX, highY]] = boundsOf(this.model.problem) ?? [[0, 0], [1, 1]];
    const box = [[0.42, 0.42], [0.58, 0.58]].map(([x, y]) => [lowX + x * (highX - lowX), lowY + y * (highY - lowY)]);
    this.model.edit(addBox(box));
    this.choose({ kind: "box", index: this.model.boxes.length - 1 });
  }

  remove() {
    const { selection } = this.model;
    if (selection?.kind !== "box") return;
    this.model.select(null);
    this.model.edit(removeBox(selection.index));
    this.say(`box ${selection.index + 1} deleted`);
  }
}

export const nameOf = ({ kind, index }) => (kind === "box" ? `box ${index + 1}` : kind);
