// The index page of a set of problems, one of which cannot be read.

import assert from "node:assert/strict";
import { test } from "node:test";
import { close, file, open, screenshot } from "./browser.mjs";

for (const colorScheme of ["light", "dark"]) {
  test(`shows every case in the ${colorScheme} scheme`, async () => {
    const page = await open("gallery/index.html", { colorScheme });
    const cards = page.locator("li");
    assert.deepEqual(await cards.locator("h2").allTextContents(), ["7ASV", "15ASV", "broken", "spoilt"]);
    assert.match(await cards.nth(0).textContent(), /✓ valid/);
    assert.match(await cards.nth(2).textContent(), /✗ broken\.txt:1:1: expected /);
    assert.match(await cards.nth(3).textContent(), /✗ not valid/);
    const images = await page.locator("img").evaluateAll((all) => Promise.all(all.map(async (image) => {
      image.loading = "eager";
      await image.decode();
      return [decodeURI(new URL(image.currentSrc).pathname), image.naturalWidth];
    })));
    assert.deepEqual(images, ["7ASV", "15ASV", "spoilt"].map((name) =>
      [file(`gallery/${name}.${colorScheme}.small.svg`), 400]));
    await screenshot(page, `gallery-${colorScheme}`);
    assert.deepEqual(page.troubles, []);
    await close(page);
  });
}

test("a picture has its words as text that can be found", async () => {
  const page = await open("gallery/index.html");
  await page.getByRole("link", { name: "Picture of 7ASV, light" }).click();
  await page.waitForURL("**/7ASV.light.svg");
  const words = await page.evaluate(() => [...document.querySelectorAll("text")].map((text) => text.textContent));
  for (const wanted of ["7ASV", "start", "goal", "✓ valid", "0.2"]) assert.ok(words.includes(wanted), wanted);
  assert.equal(await page.evaluate(() => window.find("least clearance")), true);
  assert.deepEqual(page.troubles, []);
  await close(page);
});

test("a name leads to the player", async () => {
  const page = await open("gallery/index.html");
  await page.getByRole("link", { name: "spoilt", exact: true }).click();
  await page.waitForSelector("#stage");
  assert.match(await page.locator("#verdict").textContent(), /not valid/);
  assert.deepEqual(page.troubles, []);
  await close(page);
});
