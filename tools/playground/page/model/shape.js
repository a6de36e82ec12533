// A quick look at a start or a goal while it is dragged, so that it can snap to what fits. It only
// chooses what is proposed: whether that is valid is said by the engine.

import { commonPart } from "player";
import { chainDefaults, pointsOf, signedArea, turnsOf, withTurns } from "./kinematics.js";

/** Stays clear of the limits, so that rounding does not turn what was proposed into a violation. */
const margin = 1.02;

export function minimumArea(body, count) {
  const factor = body.minimum_area_factor ?? chainDefaults.minimum_area_factor;
  return count < 2 ? 0 : Math.PI * (factor * (count - 1)) ** 2;
}

/** Do the ASVs form a convex polygon of enough area? */
export function shapeFits(body, points) {
  const count = points.length / 2;
  if (count < 2) return true;
  const area = signedArea(points);
  if (Math.abs(area) < margin * minimumArea(body, count)) return false;
  const turns = turnsOf([...points, points[0], points[1], points[2], points[3]]);
  const sign = Math.sign(area);
  let sum = 0;
  for (const turn of turns) {
    if (turn * sign < 0) return false;
    sum += Math.abs(turn);
  }
  return sum < 2.1 * Math.PI;
}

/** The chain with its turns bent to one side, that of `sign`; the point `fixed` stays. */
export function bentToOneSide(points, sign, length, fixed) {
  const turns = turnsOf(points).map((turn) => sign * Math.max(sign * turn, 0));
  return withTurns(points, turns, length, fixed);
}

/** Do the links keep out of all boxes, and the points within the bounds? */
export function placeFits(problem, points) {
  const bounds = problem.bounds === undefined ? [[0, 0], [1, 1]] : problem.bounds;
  if (bounds) {
    const [[lowX, lowY], [highX, highY]] = bounds;
    if (pointsOf(points).some(([x, y]) => x < lowX || x > highX || y < lowY || y > highY)) return false;
  }
  const single = points.length === 2;
  if (single && problem.body.kind === "chain") return true;
  const links = single ? [[...points, ...points]] : points.flatMap((_, i) => (i % 2 === 0 && i + 3 < points.length ? [points.slice(i, i + 4)] : []));
  return (problem.obstacles ?? []).every(([low, high]) => links.every((link) => {
    const [from, to] = commonPart(link, [...low, ...high]);
    return from > to;
  }));
}

/** The greatest share t in [0, 1] found by halving for which fits(t) holds; fits(0) is taken for granted. */
export function greatestShare(fits) {
  if (fits(1)) return 1;
  let [low, high] = [0, 1];
  for (let i = 0; i < 8; ++i) {
    const middle = (low + high) / 2;
    if (fits(middle)) low = middle;
    else high = middle;
  }
  return low;
}
