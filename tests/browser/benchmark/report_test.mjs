// The page of a benchmark: its charts answer to the pointer, its tables to everybody.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { axeScript, close, file, open, screenshot } from "../browser.mjs";

const charts = (page) => page.evaluate(() => story.charts.map((_, i) => {
  const chart = Chart.getChart(document.querySelectorAll("canvas")[i]);
  return { title: story.charts[i].title, lines: chart.data.datasets.map((set) => set.data.length) };
}));

for (const colorScheme of ["light", "dark"]) {
  test(`shows charts and tables in the ${colorScheme} scheme`, async () => {
    const page = await open("report.html", { colorScheme });
    const shown = await charts(page);
    assert.deepEqual(shown.map((chart) => chart.title),
                     ["Solved over time", "Cost over time", "Performance profiles", "Over obstacles"]);
    for (const chart of shown) assert.ok(chart.lines.length === 2 && chart.lines.every((points) => points > 0), chart.title);
    assert.match(await page.locator(".spoilt").first().textContent(), /their times are spoilt/);
    assert.equal(await page.locator("table").count(), 8,
                 "success, four problems and directions, two of all problems, the comparison");
    await screenshot(page, `report-${colorScheme}`);
    await page.evaluate(axeScript());
    const audit = await page.evaluate(() =>
      axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"] }));
    assert.deepEqual(audit.violations.map((v) => `${v.id}: ${v.nodes.map((node) => node.target).join(", ")}`), []);
    assert.deepEqual(page.troubles, []);
    assert.deepEqual(page.requests.filter((url) => !url.startsWith("data:")), [page.address], "needs nothing but itself");
    await close(page);
  });
}

test("tells what is under the pointer", async () => {
  const page = await open("report.html");
  const canvas = page.locator("canvas").first();
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const place = await page.evaluate(() => {
    const chart = Chart.getChart(document.querySelector("canvas"));
    const [{ x, y }] = chart.getDatasetMeta(0).data.slice(1);
    return { x, y };
  });
  await page.mouse.move(box.x + place.x, box.y + place.y);
  await page.waitForFunction(() => Chart.getChart(document.querySelector("canvas")).tooltip.opacity === 1);
  const { title, body } = await page.evaluate(() => {
    const { tooltip } = Chart.getChart(document.querySelector("canvas"));
    return { title: tooltip.title, body: tooltip.body.flatMap((part) => part.lines) };
  });
  assert.match(title[0], /^[\d.]+ (µs|ms|s)$/);
  assert.ok(body.every((line) => /: [\d.]+ %$/.test(line)), JSON.stringify(body));
  await screenshot(page, "report-pointed-at");
  assert.deepEqual(page.troubles, []);
  await close(page);
});

test("shows the problem that is chosen", async () => {
  const page = await open("report.html");
  const select = page.locator("select").first();
  assert.equal(await select.locator("option").count(), 5, "all together, and four");
  await select.selectOption({ label: "3ASV, reversed" });
  const runs = await page.evaluate(() => Chart.getChart(document.querySelector("canvas")).data.datasets[0].data.length);
  assert.equal(runs, 7, "two points for each of three runs, and the end");
  assert.deepEqual(page.troubles, []);
  await close(page);
});

test("names are text, and figures those of the tables", async () => {
  const page = await open("report.html");
  const name = JSON.parse(readFileSync(file("awkward-name.json"), "utf8"));
  assert.ok((await page.locator("thead th").allTextContents()).includes(name));
  const solved = await page.locator("td.share").allTextContents();
  const [tablesOfProblems] = readFileSync(file("report.md"), "utf8").split("### All");
  const wanted = [...tablesOfProblems.matchAll(/\| (\d+ of \d+) \|/g)].map((match) => match[1]);
  assert.deepEqual(solved, wanted);
  await close(page);
});

test("nothing has to be scrolled sideways on 320 pixels", async () => {
  const page = await open("report.html", { viewport: { width: 320, height: 640 } });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 320);
  await close(page);
});
