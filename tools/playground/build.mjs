// Puts together what tools/playground.sh has compiled: build.mjs WASM OUT
//
// OUT/engine/ gets engine.js and engine.wasm with worker.js, which loads them, and asv-worker.js: the three in one text, for
// pages that have no files beside them.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const [wasm, out] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const engine = join(out, "engine");

mkdirSync(engine, { recursive: true });
for (const file of ["engine.js", "engine.wasm"]) copyFileSync(join(wasm, file), join(engine, file));
copyFileSync(join(here, "worker.js"), join(engine, "worker.js"));

const compressed = gzipSync(readFileSync(join(wasm, "engine.wasm")), { level: 9 }).toString("base64");
const text = [
  `const embeddedEngine = "${compressed}";`,
  readFileSync(join(wasm, "engine.js"), "utf8"),
  readFileSync(join(here, "worker.js"), "utf8"),
].join("\n");
writeFileSync(join(engine, "asv-worker.js"), text);
console.log(`${join(engine, "asv-worker.js")}: ${Math.round(text.length / 1000)} kB`);
