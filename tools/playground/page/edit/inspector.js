// The numbers of what is selected, to read and to type.

import { bodyPoints, centreOf, headingsOf, turnsOf } from "../model/kinematics.js";
import { bendEnd, moveEnd, putBox, setBody, setCount, turnEnd } from "../model/edits.js";
import { nameOf } from "./keys.js";

const by = (id) => document.getElementById(id);
const degrees = (angle) => (angle * 180) / Math.PI;
const rounded = (value) => String(Number(value.toFixed(6)));
const sum = (values) => values.reduce((total, value) => total + value, 0);

const boxFields = [
  ["left", (box) => box[0][0], (box, value) => [[value, box[0][1]], [value + box[1][0] - box[0][0], box[1][1]]]],
  ["bottom", (box) => box[0][1], (box, value) => [[box[0][0], value], [box[1][0], value + box[1][1] - box[0][1]]]],
  ["width", (box) => box[1][0] - box[0][0], (box, value) => [box[0], [box[0][0] + value, box[1][1]]]],
  ["height", (box) => box[1][1] - box[0][1], (box, value) => [box[0], [box[1][0], box[0][1] + value]]],
];

/** Fields of start and goal: what is read, and the edit that brings a value about. */
function endFields(problem, end) {
  const points = bodyPoints(problem, problem[end]);
  const [x, y] = problem.body.kind === "arm" ? points : centreOf(points);
  const fields = [
    ["x", x, (value) => moveEnd(end, value - x, 0)],
    ["y", y, (value) => moveEnd(end, 0, value - y)],
  ];
  if (points.length < 4) return fields;
  const turns = sum(turnsOf(points));
  const heading = headingsOf(points)[0] + (problem.body.kind === "chain" ? turns / 2 : 0);
  fields.push(["heading, \u00b0", degrees(heading), (value) => turnEnd(end, (value * Math.PI) / 180 - heading)]);
  if (points.length < 6 || problem.body.kind === "arm") return fields;
  fields.push(["bend, \u00b0", degrees(turns), (value) => bendEnd(end, ((value * Math.PI) / 180) / (turns || 1) - 1)]);
  return fields;
}

export class Inspector {
  constructor(model) {
    this.model = model;
    by("thing").addEventListener("change", () => {
      const [kind, index] = by("thing").value.split(" ");
      model.select(kind === "none" ? null : { kind, index: kind === "box" ? Number(index) : undefined });
    });
    by("count").addEventListener("change", () => model.edit(setCount(Math.round(Number(by("count").value)))));
    by("body").addEventListener("change", () => model.edit(setBody(by("body").value)));
    model.onChange(() => this.write());
  }

  write() {
    const { problem, selection } = this.model;
    by("body").value = problem.body.kind;
    by("count").value = problem.body.kind === "point" ? 1 : problem.start.length;
    by("count").disabled = problem.body.kind === "point";
    by("count-label").textContent = problem.body.kind === "arm" ? "Links" : "ASVs";
    by("delete").disabled = selection?.kind !== "box";
    by("undo").disabled = this.model.past.length === 0;
    by("redo").disabled = this.model.future.length === 0;
    this.writeThings();
    this.writeFields();
  }

  writeThings() {
    const wanted = [["none", "nothing"], ["start", "start"], ["goal", "goal"],
                    ...this.model.boxes.map((_, i) => [`box ${i}`, `box ${i + 1}`])];
    const list = by("thing");
    if (list.options.length !== wanted.length) list.replaceChildren(...wanted.map(([value, text]) => new Option(text, value)));
    const { selection } = this.model;
    list.value = !selection ? "none" : selection.kind === "box" ? `box ${selection.index}` : selection.kind;
  }

  fields() {
    const { problem, selection } = this.model;
    if (!selection) return [];
    if (selection.kind !== "box") return endFields(problem, selection.kind);
    const box = problem.obstacles[selection.index];
    return boxFields.map(([name, read, write]) => [name, read(box), (value) => putBox(selection.index, write(box, value))]);
  }

  writeFields() {
    const fields = this.fields();
    const place = by("numbers");
    const name = this.model.selection ? nameOf(this.model.selection) : "";
    const key = name + fields.map(([label]) => label).join();
    if (place.dataset.key !== key) {
      place.dataset.key = key;
      place.replaceChildren(...fields.map(([label], i) => this.field(label, i, name)));
    }
    fields.forEach(([, value], i) => {
      const input = place.children[i].querySelector("input");
      if (document.activeElement !== input) input.value = rounded(value);
    });
  }

  field(label, index, name) {
    const element = document.createElement("label");
    const input = document.createElement("input");
    Object.assign(input, { type: "number", step: "any" });
    input.setAttribute("aria-label", `${name}: ${label}`);
    input.addEventListener("change", () => {
      const value = Number(input.value);
      const [, old, edit] = this.fields()[index];
      if (input.value !== "" && Number.isFinite(value) && value !== old) this.model.edit(edit(value));
      input.value = rounded(this.fields()[index][1]);
    });
    element.append(label, input);
    return element;
  }
}
