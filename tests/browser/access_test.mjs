// For every reader: WCAG AA by axe-core in both schemes, the keyboard alone, a phone, and readers
// who prefer less motion.

import assert from "node:assert/strict";
import { test } from "node:test";
import { axeScript, close, goTo, number, open, reachedByTab, screenshot } from "./browser.mjs";

async function audit(page) {
  await page.evaluate(axeScript());
  const result = await page.evaluate(() =>
    axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"] }));
  return result.violations.map((v) => `${v.id}: ${v.nodes.map((node) => node.target).join(", ")}`);
}

for (const colorScheme of ["light", "dark"]) {
  for (const name of ["7ASV", "spoilt", "unsolved", "gallery/index"]) {
    test(`${name} meets WCAG AA in the ${colorScheme} scheme`, async () => {
      const page = await open(`${name}.html`, { colorScheme });
      if (name === "spoilt") await page.locator("#complaints button").first().click();
      for (const details of await page.locator("details").all()) await details.evaluate((e) => { e.open = true; });
      assert.deepEqual(await audit(page), []);
      if (colorScheme === "dark") await screenshot(page, `${name.replace("/", "-")}-dark`);
      assert.deepEqual(page.troubles, []);
      await close(page);
    });
  }
}

/** Of two colours "#rrggbb", as WCAG 2.1 defines it. */
function contrast(a, b) {
  const luminance = (colour) => [[1, 0.2126], [3, 0.7152], [5, 0.0722]].reduce((sum, [at, weight]) => {
    const share = parseInt(colour.slice(at, at + 2), 16) / 255;
    return sum + weight * (share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4);
  }, 0);
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

// What axe cannot see: the canvases, borders and the mark of the focus.
for (const colorScheme of ["light", "dark"]) {
  test(`what is drawn stands out in the ${colorScheme} scheme`, async () => {
    const page = await open("7ASV.html", { colorScheme });
    const colours = await page.evaluate(() => colours);
    const least = (wanted, pairs) => pairs.forEach(([front, back]) => {
      const shown = contrast(colours[front], colours[back]);
      assert.ok(shown >= wanted, `${front} on ${back}: ${shown}`);
    });
    least(4.5, [["muted", "field"], ["start", "field"], ["goal", "field"]]);
    least(3, [["obstacle", "field"], ["least", "field"], ["violation", "field"], ["muted", "page"], ["start", "page"]]);
    await close(page);
  });
}

test("nothing has to be scrolled sideways on 320 pixels", async () => {
  for (const name of ["7ASV", "spoilt", "unsolved", "gallery/index"]) {
    const page = await open(`${name}.html`, { viewport: { width: 320, height: 640 } });
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 320, name);
    await close(page);
  }
});

test("follows a change of the scheme at once", async () => {
  const page = await open("7ASV.html", { colorScheme: "light" });
  const page_colour = () => page.evaluate(() => colours.page);
  assert.equal(await page_colour(), "#ffffff");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.waitForFunction(() => colours.page === "#0d1520");
  await close(page);
});

test("everything can be reached and used by the keyboard alone", async () => {
  const page = await open("spoilt.html");
  const reached = await reachedByTab(page);
  for (const id of ["stage", "scrub", "to-start", "rewind", "step-back", "play", "step-on", "to-end", "speed",
                    "show-trails", "show-numbers", "zoom-in", "zoom-out", "zoom-fit", "summary", "button"]) {
    assert.ok(reached.includes(id), `${id} is reached; there are ${reached}`);
  }
  await page.locator("#step-on").focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Space");
  assert.equal(await number(page, "out-step"), 2, "a focused button keeps enter and space");
  await page.locator("#scrub").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowLeft");
  assert.equal(await number(page, "out-step"), 3, "the bar moves one step for each key");
  await page.keyboard.press("Space");
  await page.waitForFunction(() => Number(document.getElementById("scrub").value) > 5);
  await page.keyboard.press("Space");
  await page.locator("#speed").focus();
  const here = await number(page, "out-step");
  await page.keyboard.press("ArrowRight");
  assert.equal(await number(page, "out-step"), here, "a list keeps its own arrows");
  await close(page);
});

test("tells those who hear it where it stands, but not while playing", async () => {
  const page = await open("7ASV.html");
  await page.evaluate(() => {
    window.said = [];
    new MutationObserver(() => window.said.push(document.getElementById("announce").textContent))
      .observe(document.getElementById("announce"), { childList: true, characterData: true, subtree: true });
  });
  await page.click("#play");
  await page.waitForFunction(() => Number(document.getElementById("scrub").value) > 10);
  assert.deepEqual(await page.evaluate(() => window.said), []);
  await page.click("#play");
  const said = await page.evaluate(() => document.getElementById("announce").textContent);
  assert.match(said, /^Step [\d,]+ of [\d,]+, cost [\d.]+$/);
  await close(page);
});

test("works on a phone", async () => {
  const page = await open("spoilt.html", {
    viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true,
  });
  const sizes = await page.evaluate(() => [...document.querySelectorAll("button, select, summary, .toggles label")]
    .filter((e) => e.checkVisibility())
    .map((e) => [e.id || e.textContent.trim(), e.getBoundingClientRect().width, e.getBoundingClientRect().height]));
  for (const [name, width, height] of sizes) assert.ok(width >= 43.9 && height >= 43.9, `${name}: ${width} x ${height}`);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390, "no scrolling sideways");
  await page.tap("#play");
  await page.waitForFunction(() => Number(document.getElementById("scrub").value) > 5);
  await page.tap("#play");
  await pinch(page, 2);
  assert.ok((await page.evaluate(() => camera.zoom)) > 1.8, "two fingers zoom");
  await page.tap("#zoom-fit");
  await page.locator("#complaints button", { hasText: "collisions" }).tap();
  await screenshot(page, "phone-spoilt");
  assert.deepEqual(page.troubles, []);
  await close(page);
});

for (const [width, height] of [[844, 390], [667, 375], [932, 430]]) {
  test(`a phone on its side has the field and what moves it in reach, ${width} x ${height}`, async () => {
    const page = await open("7ASV.html", {
      viewport: { width, height }, deviceScaleFactor: 2, isMobile: true, hasTouch: true,
    });
    for (const id of ["stage", "scrub", "to-start", "rewind", "step-back", "play", "step-on", "to-end", "speed",
                      "show-trails", "zoom-in", "zoom-out", "zoom-fit"]) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height,
                `${id}: ${JSON.stringify(box)}`);
    }
    assert.ok((await page.locator("#stage").boundingBox()).height >= 0.8 * height, "the field is as high as the screen");
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, "no scrolling sideways");
    await page.locator("#plot-area").scrollIntoViewIfNeeded();
    assert.ok((await page.locator("#stage").boundingBox()).y >= 0, "the field stays while one reads on");
    await screenshot(page, `landscape-${width}`);
    assert.deepEqual(page.troubles, []);
    await close(page);
  });
}

/** Two fingers move apart on the stage until their gap has grown by the factor. */
async function pinch(page, factor) {
  await page.locator("#stage").scrollIntoViewIfNeeded();
  const box = await page.locator("#stage").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const session = await page.context().newCDPSession(page);
  const fingers = (gap) => [{ x: x - gap / 2, y, id: 0 }, { x: x + gap / 2, y, id: 1 }];
  const touch = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  await touch("touchStart", fingers(80));
  for (let i = 1; i <= 5; ++i) await touch("touchMove", fingers(80 * (1 + ((factor - 1) * i) / 5)));
  await touch("touchEnd", []);
}

test("moves nothing on its own, and less for those who ask for it", async () => {
  const page = await open("7ASV.html", { reducedMotion: "reduce" });
  await page.waitForTimeout(300);
  assert.equal(await number(page, "out-step"), 0, "nobody has pressed play");
  assert.equal(await page.evaluate(() => document.getAnimations().length), 0);
  assert.equal(await page.inputValue("#speed"), "0.25");
  await goTo(page, 10);
  assert.equal(await number(page, "out-step"), 10);
  await close(page);
});
