// Uses the player of a solved 7ASV as its reader would, and compares what it says with the file.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { close, file, goTo, number, open, pixels, screenshot, text } from "./browser.mjs";
import { area, clearance, costs, readProblem, readSolution, tightestTurn } from "./files.mjs";

const problem = readProblem(file("7ASV.txt"));
const solution = readSolution(file("7ASV.solution.txt"));
const cost = costs(solution.states);
const stats = JSON.parse(readFileSync(file("7ASV.stats.json"), "utf8"));

let page;
before(async () => { page = await open("7ASV.html"); });
after(() => close(page));

const step = () => number(page, "out-step");

test("says what is shown", async () => {
  assert.equal(await text(page, "name"), "7ASV");
  const facts = await text(page, "facts");
  assert.ok(facts.includes("7 ASVs"), facts);
  assert.ok(facts.includes(`cost ${solution.cost.toFixed(4)}`), facts);
  assert.ok(facts.includes(`${solution.steps.toLocaleString("en-US")} steps`), facts);
  if (stats.cost_lower_bound) assert.ok(facts.includes(`lower bound ${stats.cost_lower_bound.toFixed(4)}`), facts);
  assert.match(await text(page, "verdict"), /valid/);
  assert.equal(await page.locator("#alarm").isHidden(), true);
  await screenshot(page, "7ASV-start");
});

test("plays, pauses, steps and rewinds", async () => {
  assert.equal(await step(), 0);
  await page.click("#play");
  await page.waitForFunction(() => Number(document.getElementById("scrub").value) > 20);
  assert.equal(await page.getAttribute("#play", "aria-label"), "Pause");
  await page.click("#play");
  const here = await step();
  await page.waitForTimeout(150);
  assert.equal(await step(), here, "it stands still while paused");
  await page.click("#step-on");
  assert.equal(await step(), here + 1);
  await page.click("#step-back");
  await page.click("#step-back");
  assert.equal(await step(), here - 1);
  await page.click("#rewind");
  await page.waitForFunction((from) => Number(document.getElementById("scrub").value) < from - 5, here);
  await page.waitForSelector("#rewind[aria-pressed=false]");
  assert.equal(await step(), 0, "it goes back to the start, and stops");
  await page.click("#to-end");
  assert.equal(await step(), solution.steps);
  await page.click("#to-start");
  assert.equal(await step(), 0);
});

test("plays to the end at the highest speed, and from the start again", async () => {
  await page.selectOption("#speed", "16");
  await page.click("#play");
  await page.waitForSelector("#play[aria-label=Play]");
  assert.equal(await step(), solution.steps);
  await page.selectOption("#speed", "1");
  await page.click("#play");
  await page.waitForFunction((last) => Number(document.getElementById("scrub").value) < last / 2, solution.steps);
  await page.click("#play");
});

test("reads out what the solution file says", async () => {
  const k = solution.steps;
  for (const i of [0, 1, Math.floor(k / 7), Math.floor(k / 3), Math.floor(k / 2), k - 1, k]) {
    await goTo(page, i);
    const state = solution.states[i];
    const near = async (id, wanted, unit) => {
      const shown = await number(page, id);
      assert.ok(Math.abs(shown - wanted) <= 0.500001 * unit, `${id} in step ${i}: ${shown}, not ${wanted}`);
    };
    assert.equal(await step(), i);
    await near("out-cost", cost[i], 1e-4);
    await near("out-clearance", clearance(state, problem.obstacles), 1e-6);
    await near("out-area", area(state), 1e-6);
    await near("out-turn", tightestTurn(state), 0.1);
  }
  assert.equal(await text(page, "of-cost"), `of ${solution.cost.toFixed(4)}`);
  assert.ok(Math.abs((await number(page, "out-cost")) - solution.cost) <= 1e-4);
});

test("draws the chain where the file has it", async () => {
  const worst = await page.evaluate((states) => {
    let most = 0;
    states.forEach((state, i) => chainAt(i).forEach((value, c) => { most = Math.max(most, Math.abs(value - state[c])); }));
    return most;
  }, solution.states);
  assert.ok(worst <= 0.51e-10, `off by ${worst}`);
});

test("obeys the keys", async () => {
  await page.locator("#stage").focus();
  await page.keyboard.press("Home");
  assert.equal(await step(), 0);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowLeft");
  assert.equal(await step(), 1);
  await page.keyboard.press("End");
  assert.equal(await step(), solution.steps);
  await page.keyboard.press("Space");
  await page.waitForFunction((last) => Number(document.getElementById("scrub").value) < last, solution.steps);
  await page.keyboard.press("Space");
  const here = await step();
  await page.waitForTimeout(100);
  assert.equal(await step(), here);
});

test("zooms and pans by keys, buttons, wheel and mouse", async () => {
  const zoom = () => page.evaluate(() => camera.zoom);
  const centre = () => page.evaluate(() => [camera.x, camera.y]);
  await page.locator("#stage").focus();
  await page.keyboard.press("+");
  await page.keyboard.press("+");
  assert.ok(Math.abs((await zoom()) - 2.25) < 1e-9);
  const before = await centre();
  await page.keyboard.press("Shift+ArrowRight");
  assert.ok((await centre())[0] > before[0]);
  await page.keyboard.press("-");
  assert.ok(Math.abs((await zoom()) - 1.5) < 1e-9);
  await page.keyboard.press("0");
  assert.equal(await zoom(), 1);
  await page.click("#zoom-in");
  const box = await page.locator("#stage").boundingBox();
  await page.mouse.move(box.x + box.width / 4, box.y + box.height / 4);
  const under = () => page.evaluate(([x, y]) =>
    [camera.x + (x - camera.size / 2) / scaleOf(), camera.y - (y - camera.size / 2) / scaleOf()],
    [box.width / 4, box.height / 4]);
  const point = await under();
  await page.mouse.wheel(0, -400);
  await page.waitForFunction(() => camera.zoom > 2);
  const after = await under();
  assert.ok(Math.hypot(after[0] - point[0], after[1] - point[1]) < 0.01, "the point under the wheel stays");
  const from = await centre();
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 4 + 80, box.y + box.height / 4, { steps: 4 });
  await page.mouse.up();
  assert.ok((await centre())[0] < from[0], "the field follows the mouse");
  await screenshot(page, "7ASV-zoomed");
  await page.click("#zoom-out");
  await page.click("#zoom-fit");
  assert.equal(await zoom(), 1);
});

test("shows and hides trees, trails and numbers", async () => {
  await goTo(page, Math.floor(solution.steps / 2));
  for (const [name, layer] of [["trees", "layer-ground"], ["trails", "layer-trail"], ["numbers", "layer-chain"]]) {
    const was = await pixels(page, layer);
    await page.click(`#show-${name}`);
    assert.notEqual(await pixels(page, layer), was, `${name} change the picture`);
    await page.click(`#show-${name}`);
    assert.equal(await pixels(page, layer), was, `${name} come back as they were`);
  }
  await screenshot(page, "7ASV-trees");
  await page.click("#show-trees");
  await screenshot(page, "7ASV-half-way");
});

test("takes the trail back when going back", async () => {
  const painted = () => page.evaluate(() =>
    readPixels(layers.trail.canvas).filter((value, i) => i % 4 === 3 && value > 100).length);
  const half = Math.floor(solution.steps / 2);
  await goTo(page, 0);
  assert.equal(await painted(), 0);
  await goTo(page, half);
  const forwards = await painted();
  await goTo(page, solution.steps);
  assert.ok((await painted()) > 1.2 * forwards);
  await goTo(page, half);
  assert.ok(Math.abs((await painted()) - forwards) < 0.05 * forwards);
  await goTo(page, 0);
  assert.equal(await painted(), 0);
});

test("goes to the step that is clicked in a plot", async () => {
  for (const id of ["plot-clearance", "plot-area"]) {
    const box = await page.locator(`#${id}`).boundingBox();
    await page.mouse.click(box.x + box.width - 8, box.y + 40);
    assert.equal(await step(), solution.steps);
    await page.mouse.click(box.x + 48 + (box.width - 56) / 2, box.y + 40);
    const gap = Math.abs((await step()) - solution.steps / 2);
    assert.ok(gap <= solution.steps / box.width + 1, `${gap} steps off`);
  }
});

test("asks for nothing but itself, and reports no error", () => {
  assert.deepEqual(page.requests, [page.address]);
  assert.deepEqual(page.troubles, []);
});
