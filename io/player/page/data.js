// Unpacks what the writer of this file has packed, and answers questions about one state.
"use strict";

/** Bytes of a base64 text. */
function bytesOf(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

const doublesOf = (text) => new Float64Array(bytesOf(text).buffer);
const floatsOf = (text) => new Float32Array(bytesOf(text).buffer);
const integersOf = (text) => new Int32Array(bytesOf(text).buffer);

/**
 * Positions, one row of 2 * asvCount numbers for each state. They are packed column by column: each
 * number as a multiple of the unit, of these the second differences along the path, of these the
 * zigzag code (0, -1, 1, -2, ...) in groups of 7 bits, lowest first, the highest bit set where more
 * groups follow. All sums stay below 2^53 and are exact.
 */
function positionsOf(text, states, columns, unit) {
  const bytes = bytesOf(text);
  const positions = new Float64Array(states * columns);
  let at = 0;
  for (let column = 0; column < columns; ++column) {
    let value = 0;
    let difference = 0;
    for (let state = 0; state < states; ++state) {
      let code = 0;
      let weight = 1;
      let byte;
      do {
        byte = bytes[at++];
        code += (byte & 127) * weight;
        weight *= 128;
      } while (byte >= 128);
      difference += code % 2 === 0 ? code / 2 : -(code + 1) / 2;
      value += difference;
      positions[state * columns + column] = value * unit;
    }
  }
  return positions;
}

function unpackTrees(packed) {
  return packed.map((tree) => ({
    kind: tree.kind,
    points: floatsOf(tree.points),
    parents: integersOf(tree.parents),
    edges: integersOf(tree.edges),
  }));
}

/** The first index of a sorted array whose value is greater than the given one. */
function firstAbove(sorted, value) {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] > value) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** Violations of each state: a map from the index of a state to a list of them. */
function byState(violations, steps) {
  const map = new Map();
  for (const violation of violations) {
    const state = firstAbove(steps, violation.step) - 1;
    if (!map.has(state)) map.set(state, []);
    map.get(state).push(violation);
  }
  return map;
}

function unpack(packed) {
  const columns = 2 * packed.asvCount;
  // A long path has only some of its states here: this many, and the step that each of them is.
  const steps = packed.steps === "" ? Int32Array.from({ length: packed.states }, (_, i) => i) : integersOf(packed.steps);
  return {
    ...packed,
    steps,
    obstacles: doublesOf(document.getElementById("obstacles").textContent),
    positions: positionsOf(packed.positions, packed.states, columns, packed.unit),
    cost: doublesOf(packed.cost),
    clearance: doublesOf(packed.clearance),
    clearanceBroom: integersOf(packed.clearanceBroom),
    clearanceObstacle: integersOf(packed.clearanceObstacle),
    area: doublesOf(packed.area),
    turn: doublesOf(packed.turn),
    turnAsv: integersOf(packed.turnAsv),
    trees: unpackTrees(packed.trees),
    violated: byState(packed.violations, steps),
  };
}

const story = unpack(JSON.parse(document.getElementById("data").textContent));

/** The box of an obstacle: [low x, low y, high x, high y]. */
const obstacleBox = (i) => story.obstacles.subarray(4 * i, 4 * i + 4);

/** The index of the state that is shown for a step: the nearest one that the page holds. */
function stateNear(step) {
  const after = clamp(firstAbove(story.steps, step), 1, Math.max(story.states - 1, 1));
  return story.steps[after] - step < step - story.steps[after - 1] ? after : after - 1;
}

/** With a comma between thousands. */
const grouped = (number) => number.toLocaleString("en-US");

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/** The points [x, y, x, y, ...] of the chain in one state. */
function chainAt(state) {
  const columns = 2 * story.asvCount;
  return story.positions.subarray(state * columns, (state + 1) * columns);
}

function nearestOnSegment(x, y, ax, ay, bx, by) {
  const squared = (bx - ax) ** 2 + (by - ay) ** 2;
  const along = squared === 0 ? 0 : ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / squared;
  const t = clamp(along, 0, 1);
  return [ax + t * (bx - ax), ay + t * (by - ay)];
}

/** The two ends [ax, ay, bx, by] of a broom in one state; a single ASV is a broom of length 0. */
function broomAt(state, broom) {
  const chain = chainAt(state);
  const other = Math.min(broom + 1, story.asvCount - 1);
  return [chain[2 * broom], chain[2 * broom + 1], chain[2 * other], chain[2 * other + 1]];
}

/** The part of a segment in a box, as shares [from, to] of its length; empty where from > to. */
function commonPart([ax, ay, bx, by], [lowX, lowY, highX, highY]) {
  let [from, to] = [0, 1];
  for (const [start, delta, low, high] of [[ax, bx - ax, lowX, highX], [ay, by - ay, lowY, highY]]) {
    if (delta === 0) {
      if (start < low || start > high) to = -1;
      continue;
    }
    const [first, second] = [(low - start) / delta, (high - start) / delta];
    from = Math.max(from, Math.min(first, second));
    to = Math.min(to, Math.max(first, second));
  }
  return [from, to];
}

/** [x, y, x, y]: the shortest line from a broom to an obstacle; one point twice where they meet. */
function shortestLink(broom, box) {
  const [ax, ay, bx, by] = broom;
  const [from, to] = commonPart(broom, box);
  if (from <= to) {
    const t = (from + to) / 2;
    const [x, y] = [ax + t * (bx - ax), ay + t * (by - ay)];
    return [x, y, x, y];
  }
  const [lowX, lowY, highX, highY] = box;
  const links = [[ax, ay, clamp(ax, lowX, highX), clamp(ay, lowY, highY)],
                 [bx, by, clamp(bx, lowX, highX), clamp(by, lowY, highY)]];
  for (const [x, y] of [[lowX, lowY], [highX, lowY], [highX, highY], [lowX, highY]]) {
    links.push([...nearestOnSegment(x, y, ax, ay, bx, by), x, y]);
  }
  const length = ([x, y, u, v]) => Math.hypot(u - x, v - y);
  return links.reduce((best, link) => (length(link) < length(best) ? link : best));
}
