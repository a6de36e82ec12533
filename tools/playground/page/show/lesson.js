// One picture of a lesson that is alive: the field with the trees of one planner after some steps,
// which can be stepped on, and whose boxes can be dragged.

import { lastStep, playing } from "player";
import { Growth } from "./growth.js";
import { announce } from "./notice.js";

const by = (id) => document.getElementById(id);
const longest = 2; // seconds of one plan

class Lesson {
  constructor({ engine, model, view }, { lesson, step = 0, seed = 1 }) {
    Object.assign(this, { engine, model, view, planner: lesson, step: Number(step), seed: Number(seed), version: -1, asking: false });
    model.onChange(() => this.plan());
    by("lesson-step").addEventListener("input", () => this.show(Number(by("lesson-step").value)));
    by("lesson-back").addEventListener("click", () => this.show(this.step - 1));
    by("lesson-on").addEventListener("click", () => this.show(this.step + 1));
  }

  /** Plans the problem as it is now, and again when it has changed meanwhile. */
  async plan() {
    if (this.asking) return;
    this.asking = true;
    while (this.version !== this.model.version) {
      const { problem, version } = this.model;
      const answer = await this.engine.ask("plan", {
        problem, planner: this.planner, settings: {}, seed: this.seed, optimize: 0, timeLimit: longest, warm: null,
        trees: true, progress: false, slot: "lesson",
      });
      this.version = version;
      this.problem = problem;
      this.growth = new Growth(this.planner, answer);
      this.show(this.step);
    }
    this.asking = false;
  }

  show(step) {
    if (!this.growth) return;
    const { total, answer } = this.growth;
    // A wish for the end stays one when a dragged box makes the trees longer.
    this.step = Math.max(step, 0);
    const shown = Math.min(this.step, total);
    if (step <= total) this.step = shown;
    by("lesson-step").max = total;
    by("lesson-step").value = shown;
    by("lesson-step").setAttribute("aria-valuetext", `${shown} of ${total}`);
    this.view.trees = this.growth.at(shown);
    this.view.tell(this.problem, shown === total && answer.status === "solved" ? answer.states : null);
    playing.position = lastStep(); // the whole path is drawn, with what moves at its end
    this.view.paint({ ground: true });
    const sentence = this.growth.sentence(shown);
    by("lesson-sentence").textContent = sentence;
    announce(sentence);
  }
}

export function startLesson(parts, wishes) {
  document.body.classList.add("lesson");
  by("lesson").hidden = false;
  return new Lesson(parts, wishes);
}
