// Puts what planning presents into the player's story, and has the player's painters paint it.

import { camera, fieldCentre, layers, now, paintGround, paintNow, paintTrail, Plot, prepare,
  readColours, shortestLink, sparse, stage, story,
  toPageX, toPageY } from "player";
import { bodyPoints } from "../model/kinematics.js";
import { boundsOf } from "../model/edits.js";
import { columnsOf } from "../plan/planning.js";
import { minimumArea } from "../model/shape.js";
import { keepShare, writeScrub } from "./playback.js";

const by = (id) => document.getElementById(id);
const put = (id, text) => {
  if (by(id).textContent !== text) by(id).textContent = text;
};

/** The part of the plane that is shown where a problem has no bounds. */
function windowOf(problem) {
  const bounds = boundsOf(problem);
  if (bounds) return bounds.flat();
  const places = [...bodyPoints(problem, problem.start), ...bodyPoints(problem, problem.goal), ...(problem.obstacles ?? []).flat(2)];
  const reach = (problem.body.links ?? []).reduce((sum, link) => sum + link, 0);
  if (problem.body.kind === "arm") {
    const [x, y] = problem.body.base;
    places.push(x - reach, y - reach, x + reach, y + reach);
  }
  const [xs, ys] = [places.filter((_, i) => i % 2 === 0), places.filter((_, i) => i % 2 === 1)];
  const margin = 0.1 * Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 0.1);
  return [Math.min(...xs) - margin, Math.min(...ys) - margin, Math.max(...xs) + margin, Math.max(...ys) + margin];
}

/** How far all points have moved up to each state; the engine's own figures follow when all is still. */
function costsOf(states, columns) {
  const count = states.length / columns;
  const cost = new Float64Array(count);
  for (let state = 1; state < count; ++state) {
    let sum = cost[state - 1];
    for (let i = state * columns; i < (state + 1) * columns; i += 2) {
      sum += Math.hypot(states[i] - states[i - columns], states[i + 1] - states[i - columns + 1]);
    }
    cost[state] = sum;
  }
  return cost;
}

/** What the numbers beside a body count. */
const countedWords = { chain: "ASV", arm: "joint", point: "" };

/** The parts of the story that come from the problem alone. */
export function problemStory(problem) {
  const count = columnsOf(problem) / 2;
  return {
    body: problem.body.kind, words: { counted: countedWords[problem.body.kind] }, asvCount: count, bounds: windowOf(problem), minimumArea: minimumArea(problem.body, count),
    obstacles: Float64Array.from((problem.obstacles ?? []).flat(2)), trees: [], violated: new Map(), valid: true,
    start: bodyPoints(problem, problem.start), goal: bodyPoints(problem, problem.goal),
  };
}

const plots = {};

export function makePlots() {
  plots.clearance = new Plot("plot-clearance", new Float64Array(1), "least", { root: true });
  plots.area = new Plot("plot-area", new Float64Array(1), "goal", { least: 0 });
  plots.turn = new Plot("plot-turn", new Float64Array(1), "start", {});
}

export class View {
  constructor() {
    this.extra = []; // painters of the layer above: handles, marks of what is wrong
    this.trees = []; // of one planner, in a lesson
    this.hurried = false; // while something is dragged, the trail behind the chain is left out
    Object.assign(story, { states: 0, steps: new Int32Array(0), lastStep: 0 });
  }

  /** Tells the story of a problem with its path, or with none (states null). */
  tell(problem, states) {
    const windowBefore = String(story.bounds);
    Object.assign(story, problemStory(problem), { trees: this.trees });
    const columns = columnsOf(problem);
    story.states = states ? states.length / columns : 0;
    story.lastStep = Math.max(story.states - 1, 0);
    story.steps = Int32Array.from({ length: story.states }, (_, i) => i); // all states are here
    story.positions = states ?? new Float64Array(0);
    story.cost = states ? costsOf(states, columns) : new Float64Array(1);
    story.clearance = new Float64Array(Math.max(story.states, 1)).fill(NaN);
    story.clearanceBroom = new Int32Array(Math.max(story.states, 1));
    story.clearanceObstacle = new Int32Array(Math.max(story.states, 1));
    this.measured = false;
    sparse.scale = 0; // the ways were thinned for the path before this one
    if (windowBefore !== String(story.bounds)) [camera.x, camera.y] = fieldCentre();
    if (story.states > 0) keepShare();
    this.paint({ ground: true });
  }

  /** The engine's measures of every state: what the plots show. */
  measure({ clearance, area, turn, cost }) {
    Object.assign(story, { clearance, cost, area, turn });
    this.measured = true;
    const degrees = turn.map((angle) => (angle * 180) / Math.PI);
    for (const [name, values] of Object.entries({ clearance, area, turn: degrees })) {
      // Only chains have requirements on their shape.
      const useful = Number.isFinite(values[0]) && (name === "clearance" || story.body === "chain");
      by(`plot-${name}`).hidden = by(`label-${name}`).hidden = !useful;
      if (!useful) continue;
      plots[name].values = values;
      if (name === "area") plots[name].least = story.minimumArea;
      plots[name].most = Math.max(values.reduce((a, b) => Math.max(a, b), 0), name === "area" ? story.minimumArea : 0) || 1;
      plots[name].resize();
    }
    this.paint();
  }

  paint({ ground = false } = {}) {
    if (!story.bounds) return; // nothing has been told yet
    const state = now();
    if (ground) paintGround();
    if (story.states === 0) {
      for (const layer of [layers.trail, layers.chain]) prepare(layer, camera.size, camera.size);
    } else {
      if (this.hurried) prepare(layers.trail, camera.size, camera.size);
      else paintTrail(state, ground);
      if (this.measured) this.markNearest(state);
      paintNow(state);
      writeScrub();
      if (this.measured) for (const [name, plot] of Object.entries(plots)) if (!by(`plot-${name}`).hidden) plot.paint(state);
    }
    this.writeReadouts(state);
    this.paintEdit();
  }

  paintEdit() {
    if (!story.bounds) return;
    const context = by("layer-edit").getContext("2d");
    prepare(context, camera.size, camera.size);
    for (const painter of this.extra) painter(context);
  }

  /** The pixel of the stage at which a place of the plane is drawn. */
  placeOf(x, y) {
    return [toPageX(x) + stage.clientLeft, toPageY(y) + stage.clientTop];
  }

  /** Which link is nearest to which obstacle in this state: the player draws a line between them. */
  markNearest(state) {
    let least = Infinity;
    const points = story.positions.subarray(state * 2 * story.asvCount, (state + 1) * 2 * story.asvCount);
    for (let link = 0; link < Math.max(story.asvCount - 1, 1); ++link) {
      const other = Math.min(link + 1, story.asvCount - 1);
      const ends = [points[2 * link], points[2 * link + 1], points[2 * other], points[2 * other + 1]];
      for (let box = 0; 4 * box < story.obstacles.length; ++box) {
        const [x, y, u, v] = shortestLink(ends, story.obstacles.subarray(4 * box, 4 * box + 4));
        const length = Math.hypot(u - x, v - y);
        if (length >= least) continue;
        least = length;
        [story.clearanceBroom[state], story.clearanceObstacle[state]] = [link, box];
      }
    }
  }

  writeReadouts(state) {
    const solved = story.states > 0;
    for (const id of ["playback", "plots"]) by(id).classList.toggle("idle", !solved);
    by("plots").classList.toggle("stale", !this.measured);
    if (!solved || !this.measured) for (const name of ["clearance", "area", "turn"]) put(`out-${name}`, "\u2013");
    if (!solved) {
      for (const name of ["out-step", "out-cost"]) put(name, "\u2013");
      for (const name of ["of-steps", "of-cost"]) put(name, "");
      return;
    }
    put("out-step", `${state}`);
    put("of-steps", `of ${story.states - 1}`);
    put("out-cost", story.cost[state].toFixed(4));
    put("of-cost", `of ${story.cost[story.states - 1].toFixed(4)}`);
    if (!this.measured) return;
    const number = (value, digits, unit = "") => (Number.isFinite(value) ? value.toFixed(digits) + unit : "none");
    put("out-clearance", number(story.clearance[state], 5));
    put("out-area", number(story.area[state], 6));
    put("of-area", `at least ${story.minimumArea.toFixed(6)}`);
    put("out-turn", number((story.turn[state] * 180) / Math.PI, 1, "\u00b0"));
    for (const id of ["out-area", "out-turn"]) by(id).closest("div").hidden = story.body !== "chain";
  }

  watch() {
    const resize = () => {
      if (stage.clientWidth === 0) return;
      camera.size = stage.clientWidth;
      readColours();
      if (this.measured) for (const plot of Object.values(plots)) if (!plot.canvas.hidden) plot.resize();
      this.paint({ ground: true });
    };
    new ResizeObserver(resize).observe(stage);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", resize);
    let asked = false;
    camera.onChange = () => {
      if (asked) return;
      asked = true;
      requestAnimationFrame(() => {
        asked = false;
        this.paint({ ground: true });
      });
    };
    resize();
  }
}
