// One browser for the tests of a file, pages that report whatever should not happen, and a place
// for screenshots and figures.

import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after } from "node:test";
import { pathToFileURL } from "node:url";

const { ASV_BROWSER, ASV_OUT } = process.env;

// The packages lie in the build folder, where an import from here would not look for them.
const require = createRequire(join(ASV_OUT, "package.json"));
const { chromium } = require("playwright-core");

export const axeScript = () => readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

export const file = (name) => join(ASV_OUT, "pages", name);

const browser = await chromium.launch({
  executablePath: ASV_BROWSER,
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync"],
});
after(() => browser.close());

/**
 * Opens a page from disk, without a network. Its `troubles` list console errors, exceptions, and
 * requests for anything but local files; a test of everything ends with an empty list.
 */
export async function open(name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  await context.setOffline(true);
  const page = await context.newPage();
  page.troubles = [];
  page.requests = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) page.troubles.push(message.text());
  });
  page.on("pageerror", (error) => page.troubles.push(String(error)));
  page.on("request", (request) => page.requests.push(request.url()));
  page.address = pathToFileURL(file(name)).href;
  await page.addInitScript(`window.readPixels = ${readPixels}`);
  await page.goto(page.address);
  return page;
}

export const close = (page) => page.context().close();

export const screenshot = (page, name) =>
  page.screenshot({ path: join(ASV_OUT, "screenshots", `${name}.png`), fullPage: true });

export const text = (page, id) => page.locator(`#${id}`).textContent();

/** A read-out as a number: "1,234" or "0.0123" or "12.3°". */
export const number = async (page, id) => parseFloat((await text(page, id)).replaceAll(",", ""));

/** Goes through the page by the tab key: what is reached, by id, value or element. The focus has to show on each. */
export async function reachedByTab(page) {
  const reached = [];
  for (;;) {
    await page.keyboard.press("Tab");
    const [name, outlined] = await page.evaluate(() => {
      const element = document.activeElement;
      const style = getComputedStyle(element);
      return [element === document.body ? null : element.id || element.value || element.tagName.toLowerCase(),
              style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2];
    });
    if (name === null) return reached;
    assert.ok(outlined, `the focus shows on ${name}`);
    reached.push(name);
  }
}

export async function goTo(page, step) {
  await page.locator("#scrub").fill(String(step));
}

/** What a canvas shows, as a short text that differs when any pixel does. */
export const pixels = (page, id) => page.evaluate((canvas) =>
  readPixels(document.getElementById(canvas)).reduce((hash, value) => (Math.imul(hash, 31) + value) | 0, 0), id);

/** In the page: the bytes of a canvas, read from a copy, which leaves the canvas as it is. */
function readPixels(canvas) {
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext("2d", { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  return context.getImageData(0, 0, copy.width, copy.height).data;
}

/** Figures are for people to read; no test decides by the clock. */
export function record(figures) {
  const path = join(ASV_OUT, "figures.json");
  const before = existsSync(path) ? JSON.parse(readFileSync(path, "utf8")) : {};
  writeFileSync(path, `${JSON.stringify({ ...before, ...figures }, null, 2)}\n`);
  console.log(JSON.stringify(figures));
}
