// Where the points of a body are, and how a chain of given brooms moves, turns and bends.
// Points are flat arrays x1, y1, x2, y2, ... in chain order, in units of the workspace.

export const chainDefaults = { broom_length: 0.05, minimum_area_factor: 0.007 };

export const pointsOf = (flat) => Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);

/** The headings of an arm's links, in radians against the x axis. */
function linkHeadings(body, angles) {
  if (body.angles === "absolute") return angles;
  let heading = 0;
  return angles.map((angle) => (heading += angle));
}

/** The points of a body in the configuration that a problem gives as its start or its goal. */
export function bodyPoints(problem, configuration) {
  const { body } = problem;
  if (body.kind === "point") return [...configuration];
  if (body.kind === "chain") return configuration.flat();
  const points = [...body.base];
  linkHeadings(body, configuration).forEach((heading, i) => {
    points.push(points[2 * i] + body.links[i] * Math.cos(heading), points[2 * i + 1] + body.links[i] * Math.sin(heading));
  });
  return points;
}

export function centreOf(points) {
  const count = points.length / 2;
  let [x, y] = [0, 0];
  for (let i = 0; i < points.length; i += 2) {
    x += points[i] / count;
    y += points[i + 1] / count;
  }
  return [x, y];
}

export const moved = (points, dx, dy) => points.map((value, i) => value + (i % 2 === 0 ? dx : dy));

/** The points turned by an angle in radians about a place. */
export function turned(points, angle, [x, y] = centreOf(points)) {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return points.map((_, i) => {
    const [u, v] = [points[i - (i % 2)] - x, points[i - (i % 2) + 1] - y];
    return i % 2 === 0 ? x + cos * u - sin * v : y + sin * u + cos * v;
  });
}

const wrapped = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

/** A chain's headings of its links and turns at its inner points, in radians. */
export function headingsOf(points) {
  const headings = [];
  for (let i = 0; i + 3 < points.length; i += 2) {
    headings.push(Math.atan2(points[i + 3] - points[i + 1], points[i + 2] - points[i]));
  }
  return headings;
}

export function turnsOf(points) {
  const headings = headingsOf(points);
  return headings.slice(1).map((heading, i) => wrapped(heading - headings[i]));
}

/** The chain with the given turns whose point `fixed` and its link before (or behind) stay. */
export function withTurns(points, turns, length, fixed = 0) {
  const headings = headingsOf(points);
  const middle = Math.min(Math.max(fixed - 1, 0), headings.length - 1);
  for (let i = middle + 1; i < headings.length; ++i) headings[i] = headings[i - 1] + turns[i - 1];
  for (let i = middle - 1; i >= 0; --i) headings[i] = headings[i + 1] - turns[i];
  const result = [...points];
  for (let i = fixed; i < headings.length; ++i) {
    result[2 * i + 2] = result[2 * i] + length * Math.cos(headings[i]);
    result[2 * i + 3] = result[2 * i + 1] + length * Math.sin(headings[i]);
  }
  for (let i = fixed - 1; i >= 0; --i) {
    result[2 * i] = result[2 * i + 2] - length * Math.cos(headings[i]);
    result[2 * i + 1] = result[2 * i + 3] - length * Math.sin(headings[i]);
  }
  return result;
}

/** One point goes to a place; the others follow on brooms that keep their length, as a rope does. */
export function pulled(points, index, x, y, length) {
  const result = [...points];
  [result[2 * index], result[2 * index + 1]] = [x, y];
  const follow = (i, leader) => {
    const [dx, dy] = [result[2 * i] - result[2 * leader], result[2 * i + 1] - result[2 * leader + 1]];
    const scale = length / (Math.hypot(dx, dy) || 1);
    result[2 * i] = result[2 * leader] + dx * scale;
    result[2 * i + 1] = result[2 * leader + 1] + dy * scale;
  };
  for (let i = index + 1; 2 * i < result.length; ++i) follow(i, i - 1);
  for (let i = index - 1; i >= 0; --i) follow(i, i + 1);
  return result;
}

/** An arc of `count` points about a centre; `total` is the sum of its turns, in radians. */
export function arc(count, centre, heading, total, length) {
  const turn = count > 2 ? total / (count - 2) : 0;
  const points = [0, 0];
  let direction = heading - (turn * (count - 2)) / 2;
  for (let i = 1; i < count; ++i) {
    points.push(points[2 * i - 2] + length * Math.cos(direction), points[2 * i - 1] + length * Math.sin(direction));
    direction += turn;
  }
  const [x, y] = centreOf(points);
  return moved(points, centre[0] - x, centre[1] - y);
}

/** Twice-signed-area rule: positive where the closed polygon turns left. */
export function signedArea(points) {
  let twice = 0;
  const count = points.length / 2;
  for (let i = 0; i < count; ++i) {
    const j = (i + 1) % count;
    twice += points[2 * i] * points[2 * j + 1] - points[2 * j] * points[2 * i + 1];
  }
  return twice / 2;
}
