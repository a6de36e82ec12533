// The worker's messages, and planning while a box is dragged.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Engine, quantile, testcases } from "./engine.mjs";

let engine;
before(() => (engine = new Engine()));
after(() => engine.close());

const problemOf = async (name) => (await engine.read(join(testcases, name))).problem;

test("It is ready and says what it is", async () => {
  const { version } = await engine.ready;
  assert.match(version, /^\d+\.\d+\.\d+$/);
});

test("A check names the requirement that an end violates, and the ASV", async () => {
  const problem = await problemOf("3ASV.txt");
  assert.deepEqual((await engine.ask("check", { problem })).start, []);
  problem.start[2] = [problem.start[2][0] + 0.01, problem.start[2][1]];
  const { start } = await engine.ask("check", { problem });
  assert.equal(start[0].requirement, "broom lengths");
  assert.equal(start[0].broom, 2);
  const planned = await engine.ask("plan", { problem, timeLimit: 1 });
  assert.equal(planned.status, "invalid ends");
});

test("A text that is no problem is an error with its place", async () => {
  const answer = await engine.ask("read", { name: "p.txt", text: "3\n0 0 1 x" });
  assert.equal(answer.kind, "error");
  assert.deepEqual([answer.line, answer.column], [2, 7]);
});

test("The validator finds the step that is too long", async () => {
  const problem = await problemOf("3ASV.txt");
  const planned = await engine.ask("plan", { problem, seed: 1, optimize: 0, timeLimit: 60 });
  assert.ok((await engine.ask("validate", { problem, states: planned.states })).valid);
  const states = planned.states.filter((_, i) => i < 6 || i >= 60);
  const { valid, checks } = await engine.ask("validate", { problem, states });
  assert.ok(!valid);
  assert.ok(!checks.find((check) => check.name === "steps").ok);
});

test("A profile has a number for each state", async () => {
  const problem = await problemOf("3ASV.txt");
  const planned = await engine.ask("plan", { problem, seed: 1, optimize: 0, timeLimit: 60 });
  const profile = await engine.ask("profile", { problem, states: planned.states });
  for (const member of ["clearance", "area", "turn", "cost"])
    assert.equal(profile[member].length, planned.states.length / 6);
  assert.ok(Math.abs(profile.cost.at(-1) - planned.cost) < 1e-9);
});

test("All planners tell of their settings, and show their trees", async () => {
  const { planners } = await engine.ask("planners");
  const problem = await problemOf("3ASV-x4.txt");
  for (const { name, settings } of planners) {
    assert.ok(settings.every((setting) => setting.key && setting.meaning));
    const order = { problem, planner: name, seed: 1, optimize: 0, timeLimit: 300, trees: true };
    const planned = await engine.ask("plan", order);
    assert.equal(planned.status, "solved", name);
    assert.equal(planned.trees.start.points.length, 2 * planned.trees.start.parents.length);
  }
});

test("Of plans that wait in one slot the newest alone is made", async () => {
  const problem = await problemOf("7ASV.txt");
  const order = { problem, seed: 1, optimize: 0, timeLimit: 60, slot: "live" };
  const answers = await Promise.all([0, 1, 2].map(() => engine.ask("plan", order)));
  assert.equal(answers[1].status, "interrupted");
  assert.equal(answers[2].status, "solved");
});

test("Improvement shows better and better paths, and ends for a newer plan", async () => {
  const problem = await problemOf("7ASV.txt");
  const costs = [];
  const order = { problem, seed: 1, optimize: 100, timeLimit: 60, progress: true, slot: "live" };
  let newer;
  const improved = await engine.ask("plan", order, ({ cost }) => {
    costs.push(cost);
    if (costs.length === 3) newer = engine.ask("plan", { ...order, progress: false, optimize: 0 });
  });
  assert.ok(costs.every((cost, i) => i === 0 || cost <= costs[i - 1]));
  assert.ok(improved.valid && improved.cost <= costs[0]);
  assert.equal((await newer).status, "solved");
});

/** Drags a box of some size across the middle of the path of a problem, in 100 frames, each planned from the last. */
async function drag(t, name, size) {
  const problem = await problemOf(name);
  let last = await engine.ask("plan", { problem, seed: 1, optimize: 0.2, timeLimit: 60 });
  const n = problem.start.length;
  const middle = 2 * n * Math.floor(last.states.length / 4 / n);
  const [x, y] = last.states.slice(middle, middle + 2);
  const times = [];
  let none = 0, warm = last.states;
  for (let frame = 0; frame < 100; ++frame) {
    const low = [x - size / 2, y - 0.2 + 0.004 * frame];
    const moved = { ...problem, obstacles: [...problem.obstacles, [low, [low[0] + size, low[1] + size]]] };
    const begin = performance.now();
    last = await engine.ask("plan", { problem: moved, seed: frame, optimize: 0, timeLimit: 0.2, warm });
    times.push(performance.now() - begin);
    if (last.status === "solved") assert.ok(last.valid, last.violation);
    else ++none;
    warm = last.states ?? warm;
  }
  const [median, p95, worst] = [0.5, 0.95, 1].map((share) => quantile(times, share).toFixed(1));
  t.diagnostic(`${name}: median ${median} ms, p95 ${p95}, worst ${worst}; ${none} of 100 frames without a path`);
}

test("Every path shown while a box is dragged is valid", async (t) => {
  await drag(t, "3ASV-x4.txt", 0.04);
  await drag(t, "7ASV-x6.txt", 0.04);
  await drag(t, "7ASV.txt", 0.04);
});
