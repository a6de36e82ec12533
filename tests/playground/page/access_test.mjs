// The playground for everybody: axe, keyboard alone, screen readers, phones, small and large screens.

import assert from "node:assert/strict";
import { test } from "node:test";
import { axeScript, close, reachedByTab, screenshot, text } from "../../browser/browser.mjs";
import { openExample, openPlayground, placeOf, problemOf, waitFor } from "./page.mjs";

for (const colorScheme of ["light", "dark"]) {
  test(`axe finds nothing in the ${colorScheme} scheme`, async () => {
    const page = await openPlayground({ colorScheme });
    await waitFor(page, "solved");
    await page.evaluate(() => document.querySelectorAll("details").forEach((element) => { element.open = true; }));
    await page.selectOption("#thing", "start");
    await page.evaluate(axeScript());
    const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
    const serious = found.violations.filter(({ impact }) => ["serious", "critical", "moderate"].includes(impact));
    assert.deepEqual(serious.map(({ id, nodes }) => [id, nodes.map(({ target }) => target.join(" "))]), []);
    await close(page);
  });
}

test("everything can be reached by the keyboard, and the focus shows", async () => {
  const page = await openPlayground();
  await waitFor(page, "solved");
  await page.evaluate(() => document.querySelectorAll("details").forEach((element) => { element.open = true; }));
  const reached = await reachedByTab(page);
  for (const id of ["draw", "undo", "grid", "stage", "scrub", "play", "speed", "show-trails", "zoom-in", "example", "body", "count", "planner",
                    "thing", "open", "save-problem", "save-scenario", "save-solution", "share", "link", "grow", "grow-seed", "grow-speed"]) {
    assert.ok(reached.includes(id) || id === "undo", `${id} is reached; there are ${reached}`);
  }
  assert.deepEqual(page.troubles, []);
  await close(page);
});

test("boxes, start and goal are edited by keys alone, and the page says what happens", async () => {
  const page = await openPlayground();
  await openExample(page, "3ASV");
  await page.locator("#stage").focus();
  const boxes = (await problemOf(page)).obstacles.length;
  await page.evaluate(() => { // the verdict on the next path is announced as well, perhaps at once
    window.announced = [];
    const place = document.getElementById("announce");
    new MutationObserver(() => announced.push(place.textContent)).observe(place, { childList: true });
  });
  await page.keyboard.press("b");
  assert.equal((await problemOf(page)).obstacles.length, boxes + 1);
  await page.waitForFunction((words) => announced.some((text) => text.includes(words)), `box ${boxes + 1}`);
  const box = (problem) => problem.obstacles[problem.obstacles.length - 1];
  const before = box(await problemOf(page));
  for (const key of ["ArrowRight", "ArrowUp", "Shift+ArrowRight"]) await page.keyboard.press(key);
  const after = box(await problemOf(page));
  assert.ok(after[0][0] > before[0][0] && after[0][1] > before[0][1]);
  assert.ok(after[1][0] - after[0][0] > before[1][0] - before[0][0], "Shift with an arrow resizes");
  await page.keyboard.press("Delete");
  assert.equal((await problemOf(page)).obstacles.length, boxes);
  const { start } = await problemOf(page);
  for (const key of ["s", "ArrowUp", "]", ">"]) await page.keyboard.press(key);
  assert.notDeepEqual((await problemOf(page)).start, start);
  await page.keyboard.press("a");
  assert.equal((await problemOf(page)).start.length, 4);
  await page.keyboard.press("d");
  assert.equal((await problemOf(page)).start.length, 3);
  await page.keyboard.press("Control+z");
  assert.equal((await problemOf(page)).start.length, 4);
  await page.keyboard.press("Control+y");
  assert.equal((await problemOf(page)).start.length, 3);
  await waitFor(page, "solved");
  await page.keyboard.press("Escape");
  await page.keyboard.press("End");
  const [value, max] = await page.evaluate(() => [document.getElementById("scrub").value, document.getElementById("scrub").max]);
  assert.equal(value, max);
  await page.waitForFunction(() => announced.some((text) => /Step \d+ of \d+/.test(text)));
  assert.deepEqual(page.troubles, []);
  await close(page);
});

test("numbers are typed", async () => {
  const page = await openPlayground();
  await openExample(page, "3ASV");
  await page.selectOption("#thing", "box 0");
  const width = page.getByLabel("box 1: width");
  await width.fill("0.033");
  await width.press("Tab");
  const [low, high] = (await problemOf(page)).obstacles[0];
  assert.ok(Math.abs(high[0] - low[0] - 0.033) < 1e-12);
  await page.fill("#count", "12");
  await page.locator("#count").press("Tab");
  assert.equal((await problemOf(page)).goal.length, 12);
  await close(page);
});

test("a finger drags a box on a phone, and all targets are large", async () => {
  const page = await openPlayground({ viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true });
  await openExample(page, "3ASV");
  const sizes = await page.evaluate(() => [...document.querySelectorAll("button, select, summary, .toggles label")]
    .filter((element) => element.checkVisibility())
    .map((element) => [element.id || element.textContent.trim(), element.getBoundingClientRect().width, element.getBoundingClientRect().height]));
  for (const [name, width, height] of sizes) assert.ok(width >= 43.9 && height >= 43.9, `${name}: ${width} x ${height}`);
  const { obstacles } = await problemOf(page);
  const middle = obstacles[0][0].map((low, axis) => (low + obstacles[0][1][axis]) / 2);
  const [x, y] = await placeOf(page, ...middle);
  const session = await page.context().newCDPSession(page);
  const touch = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  await touch("touchStart", [{ x, y }]);
  for (let i = 1; i <= 5; ++i) await touch("touchMove", [{ x: x - 3 * i, y: y + 4 * i }]);
  await touch("touchEnd", []);
  await page.waitForFunction((low) => playground.model.problem.obstacles[0][0][0] < low, obstacles[0][0][0]);
  assert.equal(await page.evaluate(() => window.scrollY), 0, "the page stays where it is");
  assert.deepEqual(page.troubles, []);
  await close(page);
});

const screens = [[390, 844], [844, 390], [1280, 800], [2560, 1440]];
for (const [width, height] of screens) {
  for (const colorScheme of ["light", "dark"]) {
    test(`fits ${width} x ${height}, ${colorScheme}`, async () => {
      const page = await openPlayground({ viewport: { width, height }, colorScheme });
      await waitFor(page, "solved");
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, "nothing has to be scrolled sideways");
      await page.selectOption("#thing", "start");
      await page.locator("#scrub").fill("300");
      await screenshot(page, `${width}x${height}-${colorScheme}`);
      assert.deepEqual(page.troubles, []);
      await close(page);
    });
  }
}

test("grows no trees by itself for those who ask for less motion", async () => {
  const page = await openPlayground({ reducedMotion: "reduce", hash: "example=harbour" });
  await waitFor(page, "solved");
  await page.selectOption("#example", "harbour");
  await page.click("#grow");
  await page.waitForFunction(() => /There is a path/.test(document.querySelector(".pane:last-child p")?.textContent ?? ""), null, { timeout: 60000 });
  assert.equal(await page.evaluate(() => document.getAnimations().length), 0);
  await screenshot(page, "side-by-side");
  await close(page);
});
