// The index page of a set of problems, one of which cannot be read.

import assert from "node:assert/strict";
import { test } from "node:test";
import { close, file, open, screenshot } from "./browser.mjs";

for (const colorScheme of ["light", "dark"]) {
  test(`shows every case in the ${colorScheme} scheme`, async () => {
    const page = await open("gallery/index.html", { colorScheme });
    const cards = page.locator("li");
    assert.deepEqual(await cards.locator("h2").allTextContents(), ["7ASV", "broken", "spoilt"]);
    assert.match(await cards.nth(0).textContent(), /✓ valid/);
    assert.match(await cards.nth(1).textContent(), /✗ broken\.txt:1:1: expected /);
    assert.match(await cards.nth(2).textContent(), /✗ not valid/);
    const images = await page.locator("img").evaluateAll((all) => Promise.all(all.map(async (image) => {
      image.loading = "eager";
      await image.decode();
      return [decodeURI(new URL(image.currentSrc).pathname), image.naturalWidth];
    })));
    assert.deepEqual(images, ["7ASV", "spoilt"].map((name) => [file(`gallery/${name}.${colorScheme}.svg`), 880]));
    await screenshot(page, `gallery-${colorScheme}`);
    assert.deepEqual(page.troubles, []);
    await close(page);
  });
}

test("a name leads to the player", async () => {
  const page = await open("gallery/index.html");
  await page.getByRole("link", { name: "spoilt" }).click();
  await page.waitForSelector("#stage");
  assert.match(await page.locator("#verdict").textContent(), /not valid/);
  assert.deepEqual(page.troubles, []);
  await close(page);
});
