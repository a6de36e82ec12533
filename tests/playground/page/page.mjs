// Opens the playground and speaks with it, for the tests of this folder.

import { open } from "../../browser/browser.mjs";

export const pageName = "asv-playground.html";

/** Opens the page with an address after "#", and waits until it has a problem. */
export async function openPlayground({ hash = "", ...options } = {}) {
  const page = await open(pageName, options);
  if (hash) {
    await page.goto("about:blank");
    await page.goto(`${page.address}#${hash}`);
  }
  await page.waitForFunction(() => window.playground?.model.problem);
  return page;
}

/** Waits until the problem as it is now has one of the states of <body data-state>: "solved", "infeasible", "invalid ends", "unknown". */
export const waitFor = (page, state) => page.waitForFunction(
  (wanted) => document.body.dataset.state === wanted && playground.planning.shown.version === playground.model.version,
  state, { timeout: 60000 });

/** Opens an example by its name and waits for its verdict. */
export async function openExample(page, name, state = "solved") {
  await page.selectOption("#example", name);
  await page.waitForFunction((wanted) => playground.model.name === wanted && playground.planning.shown.version === playground.model.version, name);
  await waitFor(page, state);
}

/** Where a place of the plane is on the page. */
export async function placeOf(page, x, y) {
  const box = await page.locator("#stage").boundingBox();
  const [pageX, pageY] = await page.evaluate(([u, v]) => playground.view.placeOf(u, v), [x, y]);
  return [box.x + pageX, box.y + pageY];
}

/** Drags with the mouse from one place of the plane to another, in some moves. */
export async function drag(page, from, to, moves = 10) {
  await page.mouse.move(...await placeOf(page, ...from));
  await page.mouse.down();
  for (let i = 1; i <= moves; ++i) {
    const share = i / moves;
    await page.mouse.move(...await placeOf(page, from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])));
  }
  await page.mouse.up();
}

export const problemOf = (page) => page.evaluate(() => playground.model.problem);

/** The value below which a share of all values lies. */
export function percentile(values, share) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(Math.floor(share * sorted.length), sorted.length - 1)];
}
