// A spoilt solution: the player marks what the validator reports, no more and no less. And pages
// that have no solution, or a name that looks like a program.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { close, file, goTo, number, open, pixels, screenshot, text } from "./browser.mjs";

const validation = JSON.parse(readFileSync(file("spoilt.json"), "utf8"));
const failed = validation.parts[0].checks.filter((check) => !check.ok);

let page;
before(async () => { page = await open("spoilt.html"); });
after(() => close(page));

test("the solution is spoilt in the ways that are tested here", () => {
  assert.deepEqual(failed.map((check) => check.check), ["steps", "cost", "broom lengths", "collisions"]);
});

test("says that the solution is not valid, and why", async () => {
  const verdict = `not valid: ${failed.length} of ${validation.parts[0].checks.length} requirements violated`;
  assert.ok((await text(page, "verdict")).includes(verdict), await text(page, "verdict"));
  assert.equal(await page.locator("#verdict").evaluate((e) => getComputedStyle(e).color),
               await page.locator("#complaints b").first().evaluate((e) => getComputedStyle(e).color));
  const complaints = await page.locator("#complaints li").allTextContents();
  assert.equal(complaints.length, failed.length);
  failed.forEach((check, i) => assert.ok(complaints[i].includes(check.check), complaints[i]));
  await screenshot(page, "spoilt-start");
});

test("marks every state that the validator rejects", async () => {
  const shown = await page.evaluate(() => story.violations.map((v) => [v.check, v.step, v.asv, v.broom, v.obstacle]));
  const wanted = failed.filter((check) => check.check !== "cost").flatMap((check) =>
    check.offenders.map((o) => [check.check, o.state, (o.asv ?? 0) - 1, (o.broom ?? 0) - 1, (o.obstacle ?? 0) - 1]));
  const sorted = (list) => list.map((entry) => entry.join(" ")).sort();
  assert.deepEqual(sorted(shown), sorted(wanted));
});

test("leads to the step of a violation and shows it in red", async () => {
  const collision = failed.find((check) => check.check === "collisions");
  await goTo(page, 0);
  assert.equal(await text(page, "alarm-here"), "None in this step.");
  const red = () => page.evaluate(() => {
    const data = readPixels(layers.chain.canvas);
    const wanted = [1, 3, 5].map((i) => parseInt(colours.violation.slice(i, i + 2), 16));
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (wanted.every((c, k) => data[i + k] === c)) ++count;
    return count;
  });
  assert.equal(await red(), 0);
  await page.locator("#complaints button", { hasText: "collisions" }).click();
  assert.equal(await number(page, "out-step"), collision.worst.state);
  assert.equal(await number(page, "out-clearance"), 0);
  const here = await text(page, "alarm-here");
  assert.ok(here.includes(`broom ${collision.worst.broom} meets obstacle ${collision.worst.obstacle}`), here);
  assert.ok((await red()) > 100);
  assert.equal(await page.locator("#out-clearance").evaluate((e) => e.classList.contains("bad")), true);
  await screenshot(page, "spoilt-collision");
});

test("marks the steps above the bar and in the plots", async () => {
  for (const id of ["marks", "plot-clearance"]) {
    const was = await pixels(page, id);
    await page.evaluate(() => { story.violated = new Map(); resize(); });
    assert.notEqual(await pixels(page, id), was);
    await page.evaluate(() => { story.violated = byState(story.violations, story.steps); resize(); });
  }
});

test("no error in the spoilt page", () => {
  assert.deepEqual(page.requests, [page.address]);
  assert.deepEqual(page.troubles, []);
});

test("a problem without a solution shows start and goal", async () => {
  const unsolved = await open("unsolved.html");
  assert.match(await text(unsolved, "verdict"), /start and goal are valid/);
  assert.equal(await unsolved.locator("#playback").isHidden(), true);
  assert.equal(await unsolved.locator("#no-solution").isVisible(), true);
  await unsolved.keyboard.press("Space");
  await unsolved.keyboard.press("ArrowRight");
  await screenshot(unsolved, "unsolved");
  assert.deepEqual(unsolved.troubles, []);
  await close(unsolved);
});

test("a name is text, whatever it looks like", async () => {
  const awkward = await open("awkward.html");
  const name = JSON.parse(readFileSync(file("awkward-name.json"), "utf8"));
  assert.equal(await text(awkward, "name"), name);
  assert.equal(await awkward.title(), name);
  assert.equal(await awkward.locator("img").count(), 0);
  assert.deepEqual(awkward.requests, [awkward.address]);
  assert.deepEqual(awkward.troubles, []);
  await close(awkward);
});
