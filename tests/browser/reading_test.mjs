// What helps to read a page: limits beside figures, the legend, the values of axes, coordinates under
// the pointer, and each body in its own words.

import assert from "node:assert/strict";
import { test } from "node:test";
import { close, goTo, open, screenshot, text } from "./browser.mjs";

const legend = async (page) => {
  const entries = await page.locator("#legend li").evaluateAll((all) =>
    all.filter((entry) => entry.checkVisibility()).map((entry) => entry.textContent.trim().replace(/\s+/g, " ")));
  return entries;
};

test("figures have their limits beside them", async () => {
  const page = await open("7ASV.html");
  await goTo(page, 100);
  assert.match(await text(page, "at-clearance"), /^broom [1-6], obstacle [1-7], minimum 0$/);
  assert.match(await text(page, "of-area"), /^minimum 0\.005542$/);
  assert.match(await text(page, "at-turn"), /^at ASV [1-7], maximum 180\u00b0$/);
  await close(page);
});

test("the legend tells what is there, and nothing else", async () => {
  const solved = await open("7ASV.html");
  const entries = await legend(solved);
  for (const wanted of ["start", "goal", "ASV 1 has an eye", "chain in this step", "path of an ASV", "closing side",
                        "share of the cost, from start to goal", "clearance in this step", "start tree (ASV 1)"]) {
    assert.ok(entries.includes(wanted), `${wanted} is among ${entries}`);
  }
  assert.ok(!entries.includes("violated requirement"));
  await close(solved);
  const spoilt = await open("spoilt.html");
  assert.ok((await legend(spoilt)).includes("violated requirement"));
  await close(spoilt);
  const unsolved = await open("unsolved.html");
  assert.deepEqual(await legend(unsolved), ["start", "goal", "ASV 1 has an eye", "closing side"]);
  await close(unsolved);
});

test("the coordinates under the pointer are those of the plane", async () => {
  const page = await open("7ASV.html");
  const note = page.locator("#coordinates");
  assert.equal(await note.isHidden(), true);
  const box = await page.locator("#stage").boundingBox();
  const hover = async (x, y) => {
    const [pageX, pageY] = await page.evaluate(([u, v]) => [toPageX(u), toPageY(v)], [x, y]);
    await page.mouse.move(box.x + 1 + pageX, box.y + 1 + pageY);
  };
  for (const [x, y] of [[0.25, 0.75], [0.9, 0.1]]) {
    await hover(x, y);
    const [, shownX, shownY] = (await note.textContent()).match(/^x (-?[\d.]+), y (-?[\d.]+)$/);
    assert.ok(Math.abs(shownX - x) < 0.003 && Math.abs(shownY - y) < 0.003, `${shownX}, ${shownY}`);
  }
  const digits = async () => (await note.textContent()).match(/^x -?\d+\.(\d+)/)[1].length;
  const before = await digits();
  await page.mouse.wheel(0, -4000);
  await page.waitForFunction(() => camera.zoom > 100);
  assert.ok((await digits()) >= before + 2, "more digits where the view is enlarged");
  await page.mouse.move(2, 2);
  assert.equal(await note.isHidden(), true);
  await close(page);
});

test("plots have the values of both axes", async () => {
  const page = await open("7ASV.html");
  assert.deepEqual(await page.evaluate(() => roundSteps(1692, 4)), [0, 500, 1000, 1500]);
  assert.deepEqual(await page.evaluate(() => roundSteps(3, 5)), [0, 1, 2, 3]);
  assert.deepEqual(await page.evaluate(() => roundSteps(0, 5)), [0]);
  assert.deepEqual(await page.evaluate(() => roundSteps(1000000, 4)), [0, 500000, 1000000]);
  const written = await page.evaluate(() => {
    const words = [];
    const still = plots[0].still;
    const fillText = still.fillText;
    still.fillText = function (word, ...at) { words.push(word); return fillText.call(this, word, ...at); };
    plots[0].resize();
    return words;
  });
  assert.ok(written.includes("0.02") && written.includes("500"), written.join(" "));
  await close(page);
});

test("an arm has links and joints, a point has neither", async () => {
  const arm = await open("arm.html");
  await goTo(arm, 50);
  assert.match(await text(arm, "at-clearance"), /^link [1-4], obstacle \d+, minimum 0$/);
  assert.deepEqual(await arm.evaluate(() => [0, 1, 4].map((point) => labelOf(point, 5))), ["joint 1", "2", "tip"]);
  assert.ok((await legend(arm)).includes("the base has an eye"));
  await arm.click("#show-numbers");
  await screenshot(arm, "arm");
  assert.deepEqual(arm.troubles, []);
  await close(arm);
  const point = await open("point.html");
  await goTo(point, 50);
  assert.match(await text(point, "at-clearance"), /^obstacle \d+, minimum 0$/);
  assert.equal(await point.evaluate(() => labelOf(0, 1)), "point");
  assert.doesNotMatch(await point.locator("main").innerText(), /link|broom|ASV|joint/);
  await point.click("#show-numbers");
  await screenshot(point, "point");
  assert.deepEqual(point.troubles, []);
  await close(point);
});
