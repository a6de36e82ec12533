// Draws why there is no path, where it is: the places that an ASV can reach, or the two senses in
// which the chain turns. The engine has the proof; this is its picture.

import { colours, scaleOf, toPageX, toPageY } from "player";
import { bodyPoints, centreOf, signedArea } from "../model/kinematics.js";
import { boundsOf } from "../model/edits.js";

const inside = (value, low, high) => value >= low && value <= high;

/** The edges of all boxes within the bounds on one axis, in order: between two of them nothing changes. */
function linesOf(problem, axis) {
  const [low, high] = boundsOf(problem);
  const edges = problem.obstacles.flatMap(([a, b]) => [a[axis], b[axis]]).filter((value) => inside(value, low[axis], high[axis]));
  return [...new Set([low[axis], ...edges, high[axis]])].sort((a, b) => a - b);
}

/** Cells between the edges of boxes, each free or not; exact, however thin a wall is. */
function cellsOf(problem) {
  const [xs, ys] = [linesOf(problem, 0), linesOf(problem, 1)];
  const [columns, rows] = [xs.length - 1, ys.length - 1];
  const blocked = new Uint8Array(columns * rows);
  for (const [[lowX, lowY], [highX, highY]] of problem.obstacles) {
    for (let i = 0; i < columns; ++i) {
      if (xs[i] < lowX || xs[i + 1] > highX) continue;
      for (let j = 0; j < rows; ++j) if (ys[j] >= lowY && ys[j + 1] <= highY) blocked[j * columns + i] = 1;
    }
  }
  const cellAt = (x, y) => {
    const [i, j] = [xs.findLastIndex((value) => value <= x), ys.findLastIndex((value) => value <= y)];
    return Math.min(Math.max(j, 0), rows - 1) * columns + Math.min(Math.max(i, 0), columns - 1);
  };
  return { xs, ys, columns, rows, blocked, cellAt };
}

function reachedFrom(cells, first) {
  const { columns, rows, blocked } = cells;
  const reached = new Uint8Array(columns * rows);
  const open = [first];
  reached[first] = 1;
  while (open.length > 0) {
    const cell = open.pop();
    const [i, j] = [cell % columns, Math.floor(cell / columns)];
    const next = [[i - 1, j], [i + 1, j], [i, j - 1], [i, j + 1]];
    for (const [u, v] of next) {
      const other = v * columns + u;
      if (u < 0 || v < 0 || u >= columns || v >= rows || blocked[other] || reached[other]) continue;
      reached[other] = 1;
      open.push(other);
    }
  }
  return reached;
}

/** The first ASV that cannot get to its goal, with the cells that it can reach; null where all can. */
function enclosed(problem) {
  if (!boundsOf(problem) || !problem.obstacles?.length) return null;
  const cells = cellsOf(problem);
  const [start, goal] = [bodyPoints(problem, problem.start), bodyPoints(problem, problem.goal)];
  for (let i = problem.body.kind === "arm" ? 2 : 0; i < start.length; i += 2) {
    const reached = reachedFrom(cells, cells.cellAt(start[i], start[i + 1]));
    if (!reached[cells.cellAt(goal[i], goal[i + 1])]) return { kind: "enclosed", cells, reached, index: i / 2, goal: goal.slice(i, i + 2) };
  }
  return null;
}

/** What can be drawn of the reason why a problem has no path; null for nothing. */
export function whyOf(problem) {
  const bodies = [bodyPoints(problem, problem.start), bodyPoints(problem, problem.goal)];
  if (problem.body.kind === "chain" && problem.start.length > 2 && signedArea(bodies[0]) * signedArea(bodies[1]) < 0) {
    return { kind: "senses", bodies };
  }
  return enclosed(problem);
}

/** A sentence on what is drawn. */
export function captionOf(why) {
  if (why?.kind === "senses") return "The arrows show the two senses in which the chain turns.";
  if (why?.kind === "enclosed") return `Shaded: all that ASV ${why.index + 1} can reach; its goal, crossed out, is not in it.`;
  return "";
}

function paintReached(context, { cells: { xs, ys, columns }, reached, goal }) {
  context.save();
  context.globalAlpha = 0.22;
  context.fillStyle = colours.violation;
  context.beginPath();
  for (let cell = 0; cell < reached.length; ++cell) {
    if (!reached[cell]) continue;
    const [i, j] = [cell % columns, Math.floor(cell / columns)];
    context.rect(toPageX(xs[i]), toPageY(ys[j + 1]), (xs[i + 1] - xs[i]) * scaleOf(), (ys[j + 1] - ys[j]) * scaleOf());
  }
  context.fill();
  context.restore();
  const [x, y] = [toPageX(goal[0]), toPageY(goal[1])];
  context.strokeStyle = colours.violation;
  context.lineWidth = 3;
  context.beginPath();
  for (const side of [-1, 1]) {
    context.moveTo(x - 8, y - 8 * side);
    context.lineTo(x + 8, y + 8 * side);
  }
  context.stroke();
}

function paintSense(context, points) {
  const left = signedArea(points) > 0;
  const [x, y] = centreOf(points).map((value, axis) => (axis === 0 ? toPageX(value) : toPageY(value)));
  const [radius, from, to] = [20, left ? 0.6 : Math.PI - 0.6, left ? -4 : Math.PI + 4];
  context.strokeStyle = colours.violation;
  context.lineWidth = 3;
  context.beginPath();
  context.arc(x, y, radius, from, to, left);
  const [tipX, tipY] = [x + radius * Math.cos(to), y + radius * Math.sin(to)];
  const heading = to + (left ? -Math.PI / 2 : Math.PI / 2);
  for (const turn of [2.6, -2.6]) {
    context.moveTo(tipX, tipY);
    context.lineTo(tipX + 9 * Math.cos(heading + turn), tipY + 9 * Math.sin(heading + turn));
  }
  context.stroke();
}

export function paintWhy(context, why) {
  if (why?.kind === "enclosed") paintReached(context, why);
  if (why?.kind === "senses") for (const points of why.bodies) paintSense(context, points);
}
