// Reads problem and solution files, writes them, and measures states: independent of the programs.

import { readFileSync, writeFileSync } from "node:fs";

const numbers = (line) => line.trim().split(/\s+/).map(Number);

export function readProblem(file) {
  const lines = readFileSync(file, "utf8").split("\n");
  const n = Number(lines[0]);
  const count = Number(lines[3]);
  const obstacles = lines.slice(4, 4 + count).map((line) => {
    const values = numbers(line);
    const xs = values.filter((_, i) => i % 2 === 0);
    const ys = values.filter((_, i) => i % 2 === 1);
    return { lowX: Math.min(...xs), lowY: Math.min(...ys), highX: Math.max(...xs), highY: Math.max(...ys) };
  });
  return { n, obstacles };
}

/** Each wall is a line of the file: the four corners of an obstacle. */
export function writeProblem(file, { start, goal, walls }) {
  const lines = [start.length / 2, start.join(" "), goal.join(" "), walls.length, ...walls];
  writeFileSync(file, `${lines.join("\n")}\n`);
}

export function readSolution(file) {
  const lines = readFileSync(file, "utf8").split("\n");
  const [steps, cost] = numbers(lines[0]);
  return { steps, cost, states: lines.slice(1, steps + 2).map(numbers) };
}

export function writeSolution(file, { cost, states }) {
  const lines = [`${states.length - 1} ${cost}`, ...states.map((state) => state.join(" "))];
  writeFileSync(file, `${lines.join("\n")}\n`);
}

export const moved = (a, b) => {
  let sum = 0;
  for (let i = 0; i < a.length; i += 2) sum += Math.hypot(b[i] - a[i], b[i + 1] - a[i + 1]);
  return sum;
};

export function costs(states) {
  const sums = [0];
  for (let i = 1; i < states.length; ++i) sums.push(sums[i - 1] + moved(states[i - 1], states[i]));
  return sums;
}

export function area(state) {
  let twice = 0;
  const n = state.length / 2;
  for (let i = 0; i < n; ++i) {
    const j = (i + 1) % n;
    twice += state[2 * i] * state[2 * j + 1] - state[2 * j] * state[2 * i + 1];
  }
  return Math.abs(twice) / 2;
}

/** In degrees. */
export function tightestTurn(state) {
  const n = state.length / 2;
  const heading = (i) => Math.atan2(state[2 * ((i + 1) % n) + 1] - state[2 * (i % n) + 1],
                                    state[2 * ((i + 1) % n)] - state[2 * (i % n)]);
  let most = 0;
  for (let i = 0; i < n; ++i) {
    let turn = heading(i + 1) - heading(i);
    while (turn > Math.PI) turn -= 2 * Math.PI;
    while (turn <= -Math.PI) turn += 2 * Math.PI;
    most = Math.max(most, Math.abs(turn));
  }
  return (most * 180) / Math.PI;
}

function pointToSegment(x, y, ax, ay, bx, by) {
  const squared = (bx - ax) ** 2 + (by - ay) ** 2;
  const t = Math.min(Math.max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / squared, 0), 1);
  return Math.hypot(ax + t * (bx - ax) - x, ay + t * (by - ay) - y);
}

/** The least distance of brooms that touch no obstacle: corners and ends decide. */
export function clearance(state, obstacles) {
  let least = Infinity;
  const toBox = (x, y, box) => Math.hypot(Math.max(box.lowX - x, 0, x - box.highX), Math.max(box.lowY - y, 0, y - box.highY));
  for (let i = 0; i + 3 < state.length; i += 2) {
    const [ax, ay, bx, by] = state.slice(i, i + 4);
    for (const box of obstacles) {
      least = Math.min(least, toBox(ax, ay, box), toBox(bx, by, box));
      for (const x of [box.lowX, box.highX]) {
        for (const y of [box.lowY, box.highY]) least = Math.min(least, pointToSegment(x, y, ax, ay, bx, by));
      }
    }
  }
  return least;
}
