// Sizes are limits; times are printed for people, since no test may depend on how busy the machine
// is. What a frame paints has to stay bounded, though, however long the path is.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { test } from "node:test";
import { close, file, number, open, record, screenshot } from "./browser.mjs";

const megabytes = (name) => statSync(file(name)).size / 1e6;

test("10,000 steps of 15 ASVs fit into 5 MB", () => {
  record({ "long-10000.html, MB": megabytes("long-10000.html"), "long-30000.html, MB": megabytes("long-30000.html") });
  assert.ok(megabytes("long-10000.html") < 5);
});

async function metrics(session) {
  const list = (await session.send("Performance.getMetrics")).metrics;
  return Object.fromEntries(list.map(({ name, value }) => [name, value]));
}

for (const steps of [10000, 30000]) {
  test(`opens ${steps} steps`, async () => {
    const page = await open(`long-${steps}.html`);
    const loaded = await page.evaluate(() => performance.getEntriesByType("navigation")[0].loadEventEnd);
    // Once more for the processor time alone, which other work on the machine does not change.
    const session = await page.context().newCDPSession(page);
    await session.send("Performance.enable", { timeDomain: "threadTicks" });
    const before = await metrics(session);
    await page.reload();
    const after = await metrics(session);
    record({ [`open ${steps} steps`]: {
      "wall clock, ms": Math.round(loaded),
      "main thread, ms": Math.round(1000 * (after.TaskDuration - before.TaskDuration)) } });
    assert.deepEqual(page.troubles, []);
    await close(page);
  });
}

for (const command of ["play", "rewind"]) {
  test(`${command} 30,000 steps`, async () => {
    const page = await open("long-30000.html");
    const session = await page.context().newCDPSession(page);
    await session.send("Performance.enable", { timeDomain: "threadTicks" });
    await page.selectOption("#speed", "4");
    await page.click(command === "play" ? "#to-start" : "#to-end");
    const begin = await number(page, "out-step");
    await page.click(`#${command}`);
    const before = await metrics(session);
    const frames = await page.evaluate(() => new Promise((done) => {
      const times = [];
      const count = (time) => {
        times.push(time);
        if (time - times[0] < 3000) requestAnimationFrame(count);
        else done(times);
      };
      requestAnimationFrame(count);
    }));
    const after = await metrics(session);
    await page.click(`#${command}`);
    const seconds = (frames[frames.length - 1] - frames[0]) / 1000;
    record({ [`${command} 30,000 steps`]: {
      "frames per second": Number(((frames.length - 1) / seconds).toFixed(1)),
      "main thread, ms per frame": Number(((1000 * (after.TaskDuration - before.TaskDuration)) / frames.length).toFixed(2)) } });
    const moved = Math.abs((await number(page, "out-step")) - begin);
    assert.ok(moved > 100, `${moved} steps played`);
    await screenshot(page, `long-30000-${command}`);
    assert.deepEqual(page.troubles, []);
    await close(page);
  });
}

test("a frame paints a bounded number of points, however long the path", async () => {
  const page = await open("long-30000.html");
  const counts = await page.evaluate(() => {
    let points = 0;
    const lineTo = layers.trail.lineTo;
    layers.trail.lineTo = function (...at) { ++points; return lineTo.apply(this, at); };
    const cost = (from, to) => {
      goTo(from);
      points = 0;
      goTo(to);
      return points;
    };
    cost(0, lastStep());
    return { whole: cost(0, lastStep()), on: cost(15000, 15025), back: cost(15025, 15000), far: cost(lastStep(), 15000) };
  });
  record({ "points painted": counts });
  assert.ok(counts.on <= 15 * 30, "going on paints what is new");
  for (const name of ["back", "far"]) assert.ok(counts[name] <= counts.whole / 10, `${name}: ${counts[name]}`);
  await close(page);
});
