// The pictures of the lesson, alive, and the planners side by side.

import assert from "node:assert/strict";
import { test } from "node:test";
import { close, screenshot, text } from "../../browser/browser.mjs";
import { drag, openPlayground, problemOf, waitFor } from "./page.mjs";

/** Those of docs/tutorials/playground_lesson.md, whose pictures are taken here. */
const steps = [0, 3, 8, 20, 50, 100000];

test("the six pictures of RRT-Connect show its steps", async () => {
  for (const [i, step] of steps.entries()) {
    const page = await openPlayground({ viewport: { width: 560, height: 700 }, hash: `lesson=rrt-connect&example=harbour&seed=4&step=${step}` });
    await page.waitForFunction(() => document.getElementById("lesson-sentence").textContent !== "");
    await screenshot(page, `lesson-${i + 1}`);
    const total = Number(await page.getAttribute("#lesson-step", "max"));
    assert.ok(total > 4, `${total} steps`);
    assert.equal(Number(await page.inputValue("#lesson-step")), Math.min(step, total));
    if (step >= total) assert.match(await text(page, "lesson-sentence"), /There is a path/);
    assert.deepEqual(page.troubles, []);
    await close(page);
  }
});

test("a picture answers when a box is dragged, and steps on", async () => {
  const page = await openPlayground({ viewport: { width: 560, height: 700 }, hash: "lesson=rrt-connect&example=harbour&seed=4&step=3" });
  await page.waitForFunction(() => document.getElementById("lesson-sentence").textContent !== "");
  const points = () => page.evaluate(() => JSON.stringify(playground.planning.growth.trees.map((tree) => [...tree.points])));
  const before = await points();
  const { obstacles } = await problemOf(page);
  await drag(page, [0.33, 0.3], [0.25, 0.3]);
  assert.notDeepEqual((await problemOf(page)).obstacles, obstacles);
  await page.waitForFunction(() => playground.planning.version === playground.model.version);
  assert.notEqual(await points(), before);
  await page.click("#lesson-on");
  assert.equal(await page.inputValue("#lesson-step"), "4");
  await close(page);
});

test("planners grow their trees side by side, step by step", async () => {
  const page = await openPlayground({ hash: "example=harbour" });
  await waitFor(page, "solved");
  await page.locator("#grow-speed").fill("0");
  await page.click("#grow");
  await page.waitForSelector("#grow-step:enabled", { timeout: 60000 });
  assert.ok(await page.locator(".pane").count() >= 4);
  const figures = () => page.locator(".pane small").first().textContent();
  await page.click("#grow-step");
  const before = await figures();
  await page.click("#grow-step");
  assert.notEqual(await figures(), before, "one step adds nodes");
  await page.locator("#grow-speed").fill("100");
  await page.click("#grow-pause");
  await page.waitForFunction(() => [...document.querySelectorAll(".pane p")].every((p) => /path/.test(p.textContent)), null, { timeout: 60000 });
  await page.waitForFunction(() => document.getElementById("announce").textContent !== "");
  assert.deepEqual(page.troubles, []);
  await close(page);
});
