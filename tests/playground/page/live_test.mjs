// A path follows what is dragged, and whatever is shown is valid or said to be missing.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { close, file, record, screenshot, text } from "../../browser/browser.mjs";
import { openUnwatched } from "./unwatched.mjs";
import { drag, openExample, openPlayground, pageName, percentile, placeOf, problemOf, waitFor } from "./page.mjs";

const rounded = (value) => Number(value.toFixed(1));

test("the page weighs at most 1.5 MB and asks no network", async () => {
  const size = statSync(file(pageName)).size;
  record({ "asv-playground.html, MB": size / 1e6 });
  assert.ok(size <= 1.5e6, `${size} bytes`);
  const page = await openPlayground();
  await waitFor(page, "solved");
  assert.ok(page.requests.every((address) => /^(file|blob|data):/.test(address)), page.requests.join());
  assert.match(await text(page, "verdict"), /Valid path/);
  assert.deepEqual(page.troubles, []);
  await close(page);
});

test("shows a path soon after it is opened", async () => {
  const address = pathToFileURL(file(pageName)).href;
  const times = await openUnwatched(address, { expression: "window.playground?.planning.firstPathAt", times: 10, patience: 3000 });
  record({ "first path after opening, ms": times.map(rounded) });
  assert.equal(times.length, 10);
});

/**
 * In the page: after every frame, what is on show is judged by the engine's validator. Frames that
 * show no path have to say so.
 */
async function judgeFrames(page) {
  await page.evaluate(() => {
    const { planning } = playground;
    window.judged = { frames: 0, withPath: 0, without: 0, wrong: [], shown: new Set() };
    let last = null;
    const look = () => {
      if (!window.judged) return;
      const { shown } = planning;
      ++judged.frames;
      const says = document.body.dataset.path;
      if (says === "valid") ++judged.withPath;
      else ++judged.without;
      if ((says === "valid") !== (shown.state === "solved")) judged.wrong.push(`says ${says}, shows ${shown.state}`);
      if (says !== "valid" && document.getElementById("verdict").textContent.includes("Valid")) judged.wrong.push("claims a path");
      if (shown !== last && shown.state === "solved") judged.shown.add(shown);
      last = shown;
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
}

/** What was shown, after the drag: every path against its own problem, by the validator. */
const verdicts = (page) => page.evaluate(async () => {
  const { frames, withPath, without, wrong, shown } = judged;
  window.judged = null;
  for (const { problem, answer } of shown) {
    const verdict = await playground.engine.ask("validate", { problem, states: answer.states.slice() });
    if (!verdict.valid) wrong.push(JSON.stringify(verdict.checks));
  }
  return { frames, withPath, without, wrong, paths: shown.size };
});

const moreBoxes = [[[0.47, 0.08], [0.5, 0.11]], [[0.78, 0.72], [0.82, 0.76]], [[0.6, 0.3], [0.63, 0.33]]];
const cases = [
  { what: "7ASV", name: "7ASV", from: [0.7, 0.645], to: [0.35, 0.2], more: [] },
  { what: "7ASV with 10 boxes", name: "7ASV", from: [0.7, 0.645], to: [0.35, 0.2], more: moreBoxes },
  { what: "3ASV", name: "3ASV", from: null, to: null, more: [] },
];

for (const { what, name, from, to, more } of cases) {
  test(`a path follows a box that is dragged across that of ${what} for 100 frames`, async () => {
    const page = await openPlayground();
    await openExample(page, name);
    if (more.length > 0) {
      await page.evaluate((boxes) => playground.model.edit((problem) => ({ ...problem, obstacles: [...boxes, ...problem.obstacles] })), more);
      await waitFor(page, "solved");
    }
    const problem = await problemOf(page);
    const [low, high] = problem.obstacles[problem.obstacles.length - 1];
    const start = from ?? [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
    const end = to ?? [0.5, 0.3];
    await page.evaluate(() => { playground.planning.timings.length = 0; });
    await judgeFrames(page);
    await screenshot(page, `before-dragging-${what.replaceAll(" ", "-")}`);
    await page.mouse.move(...await placeOf(page, ...start));
    await page.mouse.down();
    const moves = 100;
    for (let i = 1; i <= moves; ++i) {
      const share = i <= moves / 2 ? (2 * i) / moves : 2 - (2 * i) / moves;
      const place = await placeOf(page, start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1]));
      await page.mouse.move(...place);
      await page.evaluate(() => new Promise(requestAnimationFrame));
    }
    await page.mouse.up();
    await waitFor(page, "solved");
    const timings = await page.evaluate(() => playground.planning.timings);
    const found = await verdicts(page);
    record({ [`dragging a box in ${what}`]: {
      "ms from change to path: p50": rounded(percentile(timings, 0.5)), p95: rounded(percentile(timings, 0.95)),
      worst: rounded(Math.max(...timings)), changes: timings.length, "frames with a path": found.withPath, without: found.without,
      "paths shown": found.paths } });
    assert.deepEqual(found.wrong, [], "every path on show is valid for the problem on show");
    assert.ok(found.frames >= 100 && found.paths > 10, JSON.stringify(found));
    assert.deepEqual(page.troubles, []);
    await close(page);
  });
}

test("the path gets shorter while one watches, and plays", async () => {
  const page = await openPlayground();
  await openExample(page, "7ASV");
  const costs = await page.evaluate(() => new Promise((resolve) => {
    const { planning } = playground;
    const seen = [planning.shown.answer.cost];
    const look = () => {
      const { cost } = planning.shown.answer;
      if (cost !== seen[seen.length - 1]) seen.push(cost);
      if (planning.done || seen.length > 5) resolve(seen);
      else setTimeout(look, 20);
    };
    look();
  }));
  for (let i = 1; i < costs.length; ++i) assert.ok(costs[i] < costs[i - 1], costs.join());
  const [cost, bound, ratio] = await Promise.all(["total-cost", "bound", "ratio"].map(async (id) => Number(await text(page, id))));
  assert.ok(bound > 0 && cost >= bound && Math.abs(ratio - cost / bound) < 1e-3, `${cost} ${bound} ${ratio}`);
  await page.click("#play");
  await page.waitForFunction(() => Number(document.getElementById("scrub").value) > 20);
  await page.click("#play");
  await page.waitForFunction(() => document.getElementById("out-area").textContent !== "\u2013");
  await close(page);
});

test("says that there is no path, why, and that it does not know", async () => {
  const page = await openPlayground();
  for (const [name, reason] of [["opposite-orientation", /Proven.*turns.*arrows/], ["enclosed-goal", /Proven.*separate.*Shaded/]]) {
    await openExample(page, name, "infeasible");
    assert.match(await text(page, "verdict"), /no path/);
    assert.match(await text(page, "reason"), reason);
    await screenshot(page, name);
  }
  await openExample(page, "3ASV");
  await page.evaluate(() => { // a box on the start: no planning problem at all
    const [x, y] = playground.model.problem.start[0];
    playground.model.edit((problem) => ({ ...problem, obstacles: [...problem.obstacles, [[x - 0.02, y - 0.02], [x + 0.02, y + 0.02]]] }));
  });
  await waitFor(page, "invalid ends");
  await page.waitForSelector("#violations li");
  assert.match(await text(page, "violations"), /start.*collision/i);
  await screenshot(page, "invalid-start");
  await close(page);
});

test("start and goal move, turn and bend, and stay valid", async () => {
  const page = await openPlayground();
  await openExample(page, "7ASV");
  const lengths = ({ start }) => start.slice(1).map(([x, y], i) => Math.hypot(x - start[i][0], y - start[i][1]));
  const before = await problemOf(page);
  const [first] = before.start;
  await drag(page, first, [first[0] + 0.02, first[1] - 0.05]);
  const after = await problemOf(page);
  assert.notDeepEqual(after.start, before.start);
  for (const length of lengths(after)) assert.ok(Math.abs(length - 0.05) < 1e-9, `a broom keeps its length: ${length}`);
  await waitFor(page, "solved");
  await drag(page, after.start[3], [after.start[3][0] + 0.6, after.start[3][1]], 25); // into a wall, and beyond
  await waitFor(page, "solved");
  const { start } = await page.evaluate(() => playground.engine.ask("check", { problem: playground.model.problem }));
  assert.deepEqual(start, []);
  await page.keyboard.press("Control+z");
  assert.deepEqual((await problemOf(page)).start, after.start, "one drag is one step of undo");
  await close(page);
});
