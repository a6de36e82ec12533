// Planners side by side: each plans the same problem, and then their trees grow together.

import { Engine } from "../plan/engine.js";
import { startWorker } from "../plan/worker_source.js";
import { Growth } from "./growth.js";
import { Pane } from "./pane.js";

const by = (id) => document.getElementById(id);
const chosenFirst = ["rrt", "rrt-connect", "rrt-star", "auto"];
const longest = 5; // seconds for one planner
const secondsPerFrame = 1 / 60;
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

export class Compare {
  constructor(model, planners) {
    Object.assign(this, { model, panes: [], running: false, wish: 0 });
    by("planner-choice").append(...planners.map(({ name, summary }) => {
      const label = document.createElement("label");
      const box = Object.assign(document.createElement("input"), { type: "checkbox", value: name, checked: chosenFirst.includes(name) });
      label.title = summary;
      label.append(box, ` ${name}`);
      return label;
    }));
    by("grow").addEventListener("click", () => this.start());
    by("grow-pause").addEventListener("click", () => this.setRunning(!this.running));
    by("grow-step").addEventListener("click", () => {
      this.setRunning(false);
      this.grow(1);
    });
    new ResizeObserver(() => this.panes.forEach((pane) => pane.paint())).observe(by("panes"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => requestAnimationFrame(() => this.panes.forEach((pane) => pane.paint())));
  }

  /** Plans with all chosen planners, one after the other; a newer wish ends an older one. */
  async start() {
    const wish = ++this.wish;
    this.engine ??= new Engine(startWorker); // the live path must not wait for the trees
    const { problem } = this.model;
    const names = [...by("planner-choice").querySelectorAll("input:checked")].map(({ value }) => value);
    by("panes").replaceChildren();
    this.panes = names.map((name) => new Pane(by("panes"), name));
    for (const pane of this.panes) {
      pane.figures.textContent = "planning";
      const answer = await this.engine.ask("plan", {
        problem, planner: pane.planner, settings: {}, seed: Number(by("grow-seed").value), optimize: 0, timeLimit: longest,
        warm: null, trees: true, progress: false, slot: "compare",
      }).catch((error) => ({ status: error.message, trees: null }));
      if (wish !== this.wish) return;
      pane.take(problem, new Growth(pane.planner, answer));
    }
    by("grow-step").disabled = by("grow-pause").disabled = false;
    if (reducedMotion.matches) this.grow(Infinity);
    else this.setRunning(true);
  }

  setRunning(running) {
    by("grow-pause").setAttribute("aria-pressed", String(!running));
    if (running && !this.running) requestAnimationFrame(() => this.frame());
    this.running = running;
  }

  /** Nodes for each second: from one to a hundred thousand, as the slider has it. */
  get pace() {
    return 10 ** (Number(by("grow-speed").value) / 20);
  }

  frame() {
    if (!this.running) return;
    this.due = (this.due ?? 0) + this.pace * secondsPerFrame;
    const steps = Math.floor(this.due);
    this.due -= steps;
    if (steps > 0) this.grow(steps);
    if (this.panes.every((pane) => pane.done)) this.running = false;
    else requestAnimationFrame(() => this.frame());
  }

  grow(steps) {
    for (const pane of this.panes) if (!pane.done) pane.grow(steps);
  }
}
