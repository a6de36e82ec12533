// A path with more states than a page holds: nothing that is told gets lost.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { after, before, test } from "node:test";
import { close, file, goTo, number, open, screenshot, text } from "./browser.mjs";
import { area, clearance, costs, readProblem, readSolution, tightestTurn } from "./files.mjs";

const last = 120000;
let page;
before(async () => { page = await open("long-120000.html"); });
after(() => close(page));

test("the page stays below 5 MB and says how many of the states it holds", async () => {
  assert.ok(statSync(file("long-120000.html")).size < 5e6);
  const held = await page.evaluate(() => story.states);
  assert.ok(held > 5000 && held < last, held);
  const count = (value) => value.toLocaleString("en-US");
  assert.ok((await text(page, "held")).startsWith(`This page holds ${count(held)} of ${count(last + 1)} states`));
  assert.equal(await page.locator("#held").isVisible(), true);
  assert.equal(await text(page, "of-steps"), `of ${count(last)}`);
  await screenshot(page, "long-120000");
});

test("it holds the extremes of the whole path", async () => {
  const { obstacles } = readProblem(file("long-120000.txt"));
  const { states } = readSolution(file("long-120000.solution.txt"));
  const least = (values) => values.reduce((a, b) => Math.min(a, b));
  const shown = await page.evaluate(() => ({
    clearance: story.clearance.reduce((a, b) => Math.min(a, b)),
    area: story.area.reduce((a, b) => Math.min(a, b)),
    turn: story.turn.reduce((a, b) => Math.max(a, b)),
  }));
  assert.ok(Math.abs(shown.clearance - least(states.map((state) => clearance(state, obstacles)))) < 1e-9);
  assert.ok(Math.abs(shown.area - least(states.map(area))) < 1e-9);
  assert.ok(Math.abs((shown.turn * 180) / Math.PI + least(states.map((state) => -tightestTurn(state)))) < 1e-6);
});

test("each state is told as the step that it is", async () => {
  const { states } = readSolution(file("long-120000.solution.txt"));
  const cost = costs(states);
  for (const wanted of [0, 1, 31234, 60000, last]) {
    await goTo(page, wanted);
    const step = await number(page, "out-step");
    assert.ok(Math.abs(step - wanted) <= 100, `${step} is near ${wanted}`);
    assert.ok(Math.abs((await number(page, "out-cost")) - cost[step]) <= 0.51e-4);
    const worst = await page.evaluate((state) =>
      Math.max(...chainAt(now()).map((value, i) => Math.abs(value - state[i]))), states[step]);
    assert.ok(worst < 1e-9, `off by ${worst}`);
  }
});

test("every control moves on from state to state", async () => {
  await goTo(page, 50000);
  const here = await number(page, "out-step");
  await page.click("#step-on");
  const next = await number(page, "out-step");
  assert.ok(next > here);
  await page.locator("#scrub").focus();
  await page.keyboard.press("ArrowLeft");
  assert.equal(await number(page, "out-step"), here);
  await page.keyboard.press("ArrowRight");
  assert.equal(await number(page, "out-step"), next);
  await page.click("#to-end");
  assert.equal(await number(page, "out-step"), last);
  await page.click("#rewind");
  await page.waitForFunction((end) => Number(document.getElementById("scrub").value) < end - 500, last);
  await page.click("#rewind");
  await page.selectOption("#speed", "16");
  await page.click("#to-end");
  await page.click("#play");
  await page.waitForFunction(() => Number(document.getElementById("scrub").value) > 2000);
  await page.click("#play");
  assert.deepEqual(page.troubles, []);
});
