// Edits of a problem: each returns a new problem, or the same one where nothing can be done.

import { arc, bodyPoints, centreOf, chainDefaults, headingsOf, moved, pointsOf, pulled, signedArea, turned, turnsOf, withTurns } from "./kinematics.js";
import { bentToOneSide, greatestShare, placeFits, shapeFits } from "./shape.js";

export const mostAsvs = 30;

export const boundsOf = (problem) => (problem.bounds === undefined ? [[0, 0], [1, 1]] : problem.bounds);

export const broomLength = (problem) => problem.body.broom_length ?? chainDefaults.broom_length;

const withBoxes = (problem, obstacles) => ({ ...problem, obstacles });

export const sorted = ([[ax, ay], [bx, by]]) => [[Math.min(ax, bx), Math.min(ay, by)], [Math.max(ax, bx), Math.max(ay, by)]];

export const addBox = (box) => (problem) => withBoxes(problem, [...(problem.obstacles ?? []), sorted(box)]);

export const putBox = (index, box) => (problem) =>
  withBoxes(problem, problem.obstacles.map((old, i) => (i === index ? sorted(box) : old)));

export const removeBox = (index) => (problem) => withBoxes(problem, problem.obstacles.filter((_, i) => i !== index));

export const movedBox = ([low, high], dx, dy) => [[low[0] + dx, low[1] + dy], [high[0] + dx, high[1] + dy]];

const withPoints = (problem, end, points) =>
  ({ ...problem, [end]: problem.body.kind === "point" ? points : pointsOf(points) });

const fits = (problem, points) =>
  placeFits(problem, points) && (problem.body.kind !== "chain" || shapeFits(problem.body, points));

/**
 * The end of the problem put where `wish(1)` is, or else as far on the way from wish(0), where it
 * is now, as fits. `wish` maps a share in [0, 1] to points. Without `snap` it goes there in any case.
 */
function snapped(problem, end, wish, snap) {
  if (!snap || !fits(problem, wish(0))) return withPoints(problem, end, wish(1));
  const share = greatestShare((t) => fits(problem, wish(t)));
  return share === 0 ? problem : withPoints(problem, end, wish(share));
}

/** Moves a chain or a point as a whole; an arm's base is one for start and goal, and both move. */
export const moveEnd = (end, dx, dy, snap = true) => (problem) => {
  if (problem.body.kind === "arm") {
    const [x, y] = problem.body.base;
    return { ...problem, body: { ...problem.body, base: [x + dx, y + dy] } };
  }
  const points = bodyPoints(problem, problem[end]);
  return snapped(problem, end, (t) => moved(points, t * dx, t * dy), snap);
};

/** Turns a body by an angle in radians; an arm turns about its base. */
export const turnEnd = (end, angle, snap = true) => (problem) => {
  if (problem.body.kind === "point") return problem;
  if (problem.body.kind === "arm") return bendArm(problem, end, 0, angle);
  const points = bodyPoints(problem, problem[end]);
  return snapped(problem, end, (t) => turned(points, t * angle), snap);
};

/** Is there a range (or "wrap") for each joint, and not one for all? */
const eachJoint = (joints) => Array.isArray(joints) && typeof joints[0] !== "number";

function bendArm(problem, end, joint, angle) {
  const { body } = problem;
  const limits = (i) => (eachJoint(body.joints) ? body.joints[i] : body.joints);
  const turns = problem[end].map((value, i) => {
    const follows = body.angles === "absolute" ? i >= joint : i === joint;
    if (!follows) return value;
    const limit = limits(i);
    return limit === "wrap" ? value + angle : Math.min(Math.max(value + angle, limit[0]), limit[1]);
  });
  return { ...problem, [end]: turns };
}

/** Drags point `index` of a body to a place; brooms and links keep their length. */
export const pullEnd = (end, index, x, y, snap = true) => (problem) => {
  const points = bodyPoints(problem, problem[end]);
  if (problem.body.kind === "arm") {
    if (index === 0) return moveEnd(end, x - points[0], y - points[1])(problem);
    const joint = index - 1;
    const [baseX, baseY] = [points[2 * joint], points[2 * joint + 1]];
    const now = Math.atan2(points[2 * index + 1] - baseY, points[2 * index] - baseX);
    const wished = Math.atan2(y - baseY, x - baseX) - now;
    return bendArm(problem, end, joint, Math.atan2(Math.sin(wished), Math.cos(wished)));
  }
  const [oldX, oldY] = [points[2 * index], points[2 * index + 1]];
  const sign = Math.sign(signedArea(points)) || 1;
  return snapped(problem, end, (t) => {
    if (t === 0) return points;
    const place = pulled(points, index, oldX + t * (x - oldX), oldY + t * (y - oldY), broomLength(problem));
    return points.length > 4 ? bentToOneSide(place, sign, broomLength(problem), index) : place;
  }, snap);
};

/** Bends a chain more (share > 0) or less: all its turns grow by this share of themselves. */
export const bendEnd = (end, share, snap = true) => (problem) => {
  const points = bodyPoints(problem, problem[end]);
  if (problem.body.kind === "arm") return bendArm(problem, end, problem[end].length - 1, share);
  if (problem.body.kind === "point" || points.length < 6) return problem;
  const turns = turnsOf(points);
  const [x, y] = centreOf(points);
  return snapped(problem, end, (t) => {
    const bent = withTurns(points, turns.map((turn) => turn * (1 + t * share)), broomLength(problem), points.length >> 2);
    const [u, v] = centreOf(bent);
    return moved(bent, x - u, y - v);
  }, snap);
};

/** The points of a chain of another number of ASVs: the same place, heading and roundness. */
function withCount(points, count, length) {
  if (count === 1) return centreOf(points);
  const turns = turnsOf(points);
  const headings = headingsOf(points);
  const total = turns.reduce((sum, turn) => sum + turn, 0) || 0.8 * Math.PI;
  const mean = headings.length === 0 ? 0 : headings[0] + turns.reduce((sum, turn) => sum + turn, 0) / 2;
  const least = 0.35 * Math.PI;
  const most = 2 * Math.PI * (1 - 1 / count) - 0.2;
  const round = Math.sign(total) * Math.min(Math.max(Math.abs(total), least), most);
  return arc(count, centreOf(points), mean, round, length);
}

/** A chain or an arm of another number of ASVs or links. */
export const setCount = (count) => (problem) => {
  const { body } = problem;
  if (body.kind === "point" || count < 1 || count > mostAsvs || count === problem.start.length) return problem;
  if (body.kind === "arm") {
    const length = (values, fill) => Array.from({ length: count }, (_, i) => values[i] ?? fill);
    const joints = eachJoint(body.joints) ? length(body.joints, body.joints[body.joints.length - 1]) : body.joints;
    const links = length(body.links, body.links[body.links.length - 1]);
    return { ...problem, body: { ...body, links, joints }, start: length(problem.start, 0.1), goal: length(problem.goal, 0.1) };
  }
  const resized = (end) => pointsOf(withCount(bodyPoints(problem, problem[end]), count, broomLength(problem)));
  return { ...problem, start: resized("start"), goal: resized("goal") };
};

/** Another kind of body about where the old one was, with a field of its own size. */
export const setBody = (kind) => (problem) => {
  if (kind === problem.body.kind) return problem;
  const [low, high] = boundsOf(problem) ?? [[0, 0], [1, 1]];
  const side = Math.min(high[0] - low[0], high[1] - low[1]);
  const place = (end) => centreOf(bodyPoints(problem, problem[end]));
  const common = { version: 1, bounds: [low, high], obstacles: problem.obstacles ?? [], step: side / 1000 };
  if (kind === "point") return { ...common, body: { kind }, start: place("start"), goal: place("goal") };
  if (kind === "arm") {
    const body = { kind, base: [(low[0] + high[0]) / 2, low[1]], links: [0.3, 0.25, 0.2].map((share) => share * side), angles: "relative", joints: "wrap" };
    return { ...common, body, start: [2.4, -0.3, -0.3], goal: [0.8, 0.3, 0.3] };
  }
  const length = 0.05 * side;
  const chain = (end) => pointsOf(arc(3, place(end), 0, 0.6 * Math.PI, length));
  const body = { kind, broom_length: length, minimum_area_factor: 0.007 * side };
  return { ...common, tolerance: 1e-5 * side, body, start: chain("start"), goal: chain("goal") };
};
