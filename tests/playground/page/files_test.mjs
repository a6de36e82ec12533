// What goes out of the playground comes back, and the programs accept it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { close, file, screenshot, text } from "../../browser/browser.mjs";
import { openExample, openPlayground, problemOf, waitFor } from "./page.mjs";

const { ASV_PROGRAMS, ASV_SOURCE } = process.env;

/** Clicks a button that saves a file, and returns where the file is. */
async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
  const path = file(`saved-${download.suggestedFilename()}`);
  await download.saveAs(path);
  return path;
}

const openFiles = (page) => page.evaluate(() => document.querySelectorAll("details").forEach((element) => { element.open = true; }));

for (const [name, problemButton] of [["7ASV", "#save-problem"], ["15ASV-x4", "#save-scenario"], ["arm", "#save-scenario"], ["harbour", "#save-scenario"]]) {
  test(`the native validator accepts the saved solution of ${name}`, async () => {
    const page = await openPlayground();
    await openFiles(page);
    await openExample(page, name);
    const problem = await saved(page, problemButton);
    const solution = await saved(page, "#save-solution");
    const verdict = execFileSync(join(ASV_PROGRAMS, "asv-validate"), [problem, solution, "--continuous"], { encoding: "utf8" });
    assert.match(verdict, /valid/);
    assert.deepEqual(page.troubles, []);
    await close(page);
  });
}

test("a saved problem and its solution are opened again", async () => {
  const page = await openPlayground();
  await openFiles(page);
  await openExample(page, "7ASV");
  const before = await problemOf(page);
  const [problem, solution] = [await saved(page, "#save-problem"), await saved(page, "#save-solution")];
  await openExample(page, "3ASV");
  await page.setInputFiles("#file", problem);
  await page.waitForFunction(() => playground.model.problem.start.length === 7);
  assert.deepEqual((await problemOf(page)).start, before.start);
  await waitFor(page, "solved");
  await page.setInputFiles("#file", solution);
  await page.waitForFunction(() => /is valid, and shown/.test(document.getElementById("notice").textContent));
  await page.setInputFiles("#file", join(ASV_SOURCE, "testcases", "invalid", "coordinate-word.txt"));
  await page.waitForFunction(() => /line \d/.test(document.getElementById("notice").textContent));
  assert.equal((await problemOf(page)).start.length, 7, "a file that is no problem changes nothing");
  await close(page);
});

test("a scenario is opened together with its map, and asks for it alone", async () => {
  const page = await openPlayground();
  await openFiles(page);
  const [scenario, map] = ["point-town.json", "town.png"].map((name) => join(ASV_SOURCE, "testcases", "bodies", name));
  await page.setInputFiles("#file", scenario);
  await page.waitForFunction(() => /choose it together with the scenario/.test(document.getElementById("notice").textContent));
  await page.setInputFiles("#file", [map, scenario]);
  await page.waitForFunction(() => /point-town.json with town.png is opened/.test(document.getElementById("notice").textContent));
  await waitFor(page, "solved");
  assert.equal((await problemOf(page)).obstacles.length, 25);
  await screenshot(page, "point-town");
  assert.deepEqual(page.troubles, []);
  await close(page);
});

test("a link brings the problem back exactly", async () => {
  const page = await openPlayground();
  await openFiles(page);
  await openExample(page, "7ASV-x2");
  await page.locator("#stage").focus();
  for (const key of ["b", "ArrowUp", "ArrowLeft"]) await page.keyboard.press(key);
  const problem = await problemOf(page);
  await page.click("#share");
  await page.waitForFunction(() => document.getElementById("link").value !== "");
  const link = await page.inputValue("#link");
  assert.ok(link.length < 2000, `${link.length} characters`);
  await close(page);
  const other = await openPlayground({ hash: link.slice(link.indexOf("#") + 1) });
  assert.deepEqual(await problemOf(other), problem);
  await close(other);
  const spoilt = await openPlayground({ hash: "p=nonsense" });
  assert.match(await text(spoilt, "notice"), /holds no problem/);
  await waitFor(spoilt, "solved");
  await close(spoilt);
});

test("every example opens, and has the verdict that it shall have", async () => {
  const page = await openPlayground();
  const names = await page.evaluate(() => [...document.querySelectorAll("#example option")].map(({ value, parentElement }) => [value, parentElement.label]));
  assert.ok(names.length > 20);
  for (const [name, group] of names) {
    await openExample(page, name, group === "Without a path" ? "infeasible" : "solved");
  }
  assert.deepEqual(page.troubles, []);
  await close(page);
});

test("problems of the page are files of the programs", async () => {
  const page = await openPlayground();
  await openFiles(page);
  await openExample(page, "7ASV");
  const problem = await saved(page, "#save-problem");
  const numbers = (path) => readFileSync(path, "utf8").split(/\s+/).filter(Boolean).map(Number);
  const original = numbers(join(ASV_SOURCE, "testcases", "7ASV.txt"));
  assert.deepEqual(numbers(problem).slice(0, 29), original.slice(0, 29));
  await close(page);
});
