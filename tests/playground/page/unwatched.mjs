// A page opened in a Chromium that nobody looks into until it has done its work. Whoever listens to a
// page gets a copy of everything that it loads, and a page of one file opens half a second later for it.

import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

const { ASV_BROWSER, ASV_OUT } = process.env;
const { chromium } = createRequire(join(ASV_OUT, "package.json"))("playwright-core");

const between = 100; // milliseconds between two looks at something that is waited for

/** The port of a browser that has just been started with this folder. */
async function portOf(folder) {
  const file = join(folder, "DevToolsActivePort");
  while (!existsSync(file) || !readFileSync(file, "utf8").includes("\n")) await sleep(between);
  return readFileSync(file, "utf8").split("\n")[0];
}

/** What an expression is worth in a page, in a new tab of a running browser, after a while, and once it is worth something. */
async function askTab(door, address, expression, patience) {
  await fetch(`${door}/json/new?${address}`, { method: "PUT" });
  await sleep(patience);
  const browser = await chromium.connectOverCDP(door);
  const page = browser.contexts().flatMap((context) => context.pages()).find((one) => one.url() === address);
  const value = await (await page.waitForFunction(expression)).jsonValue();
  await page.close();
  await browser.close();
  return value;
}

/**
 * Opens a page again and again, each time in a new tab that is left alone for `patience` milliseconds: what an expression is
 * worth in each after that.
 */
export async function openUnwatched(address, { expression, times, patience }) {
  const folder = mkdtempSync(join(tmpdir(), "asv-browser-"));
  const browser = spawn(ASV_BROWSER, ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
    "--remote-debugging-port=0", `--user-data-dir=${folder}`, "about:blank"], { stdio: "ignore" });
  try {
    const door = `http://127.0.0.1:${await portOf(folder)}`;
    await sleep(patience); // the browser's own start is not the page's
    const values = [];
    for (let i = 0; i < times; ++i) values.push(await askTab(door, address, expression, patience));
    return values;
  } finally {
    const ended = new Promise((resolve) => browser.once("exit", resolve));
    browser.kill();
    await ended;
    rmSync(folder, { recursive: true, force: true, maxRetries: 10, retryDelay: between });
  }
}
