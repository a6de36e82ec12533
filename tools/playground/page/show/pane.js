// One planner among others: a small field with its trees, its figures and a sentence on each step.

import { camera, colours, colourAlong, fieldCentre, paintEnd, paintGrid, paintObstacles, paintTree, prepare, story, toPageX, toPageY } from "player";
import { problemStory } from "./view.js";

/** Paints with the player's painters another problem than the one on the stage, into a square of another size. */
function borrowed(told, size, paint) {
  const [storyBefore, cameraBefore] = [{ ...story }, { ...camera }];
  Object.assign(story, told);
  const [x, y] = fieldCentre();
  Object.assign(camera, { zoom: 1, x, y, size });
  paint();
  Object.assign(story, storyBefore);
  Object.assign(camera, cameraBefore);
}

export class Pane {
  constructor(place, planner) {
    this.planner = planner;
    this.element = document.createElement("article");
    this.element.className = "pane";
    const [title, canvas, figures, sentence] = ["h3", "canvas", "small", "p"].map((name) => document.createElement(name));
    title.textContent = planner;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `Trees of ${planner}`);
    Object.assign(this, { canvas, figures, sentence, growth: null, step: 0 });
    this.element.append(title, canvas, figures, sentence);
    place.append(this.element);
    figures.textContent = "waiting";
  }

  /** The trees of an answer to a problem, at their beginning. */
  take(problem, growth) {
    Object.assign(this, { told: problemStory(problem), growth, step: 0 });
    const { status, seconds, cost, bound } = growth.answer;
    const ratio = status === "solved" && bound > 0 ? `, ratio ${(cost / bound).toFixed(3)}` : "";
    this.outcome = status === "solved" ? `${(1000 * seconds.first).toFixed(1)} ms, cost ${cost.toFixed(4)}${ratio}` : status;
    this.paint();
  }

  get done() {
    return !this.growth || this.step >= this.growth.total;
  }

  grow(steps) {
    this.step = Math.min(this.step + steps, this.growth.total);
    this.paint();
  }

  paint() {
    if (!this.growth) return;
    const size = this.canvas.clientWidth;
    const context = this.canvas.getContext("2d");
    prepare(context, size, size);
    const trees = this.growth.at(this.step);
    borrowed(this.told, size, () => {
      paintGrid(context);
      paintObstacles(context);
      for (const tree of trees) paintTree(context, tree);
      if (this.done && this.growth.answer.status === "solved") this.paintPath(context);
      paintEnd(context, story.start, colours.start, "start");
      paintEnd(context, story.goal, colours.goal, "goal");
    });
    const shown = trees.reduce((sum, { parents }) => sum + parents.length, 0);
    this.figures.textContent = `${shown} of ${this.growth.nodes} nodes${this.done ? `, ${this.outcome}` : ""}`;
    this.sentence.textContent = this.growth.sentence(this.step);
  }

  /** The way of the point that the trees show: ASV 1, the tip of an arm, or the point. */
  paintPath(context) {
    const { states } = this.growth.answer;
    const columns = 2 * story.asvCount;
    const at = story.body === "arm" ? columns - 2 : 0;
    const pieces = 24;
    const count = states.length / columns;
    context.lineWidth = 3;
    for (let piece = 0; piece < pieces; ++piece) {
      context.strokeStyle = colourAlong(piece / pieces);
      context.beginPath();
      const end = Math.min(Math.ceil(((piece + 1) * count) / pieces), count - 1);
      for (let state = Math.floor((piece * count) / pieces); state <= end; ++state) {
        context.lineTo(toPageX(states[state * columns + at]), toPageY(states[state * columns + at + 1]));
      }
      context.stroke();
    }
  }
}
