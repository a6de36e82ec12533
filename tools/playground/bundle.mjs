// Joins the page of the playground, its style and the player's scripts into files that a browser
// opens: bundle.mjs ENGINE OUT, with the npm packages of package.json in OUT/npm.
//
// ENGINE is the folder of the built engine, with engine.js, engine.wasm and worker.js; OUT gets asv-playground.html, all in one file.

import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { Worker } from "node:worker_threads";
import { gzipSync } from "node:zlib";

const [engine, out] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const root = resolve(here, "../..");
const { build } = createRequire(join(out, "npm", "package.json"))("esbuild");
const text = (...path) => readFileSync(join(...path), "utf8");

/** The scripts of the player that the playground stands on, in the order in which the player has them. */
const playerScripts = ["data.js", "camera.js", "field.js", "moving.js", "plots.js", "playback.js"];

/** They share one scope and export nothing; here they are one module that exports every name. */
function playerModule() {
  const scripts = playerScripts.map((name) => text(root, "io/player/page", name)).join("\n").replace('"use strict";\n', "");
  const names = [...scripts.matchAll(/^(?:const|let|class|function) (\w+)/gm)].map((match) => match[1]);
  return `import { announce, show } from ${JSON.stringify(join(here, "page/show/playback.js"))};\n${scripts}\nexport { ${names.join(", ")} };\n`;
}

/** Problems that are opened by name, as the engine reads them: those of testcases/, and some of the playground's own. */
async function examplesModule() {
  const groups = [["Chains", "testcases"], ["Without a path", "testcases/infeasible"], ["Other bodies", "tools/playground/examples"]];
  const examples = groups.flatMap(([group, folder]) => readdirSync(join(root, folder))
    .filter((file) => /\.(txt|json)$/.test(file))
    .sort((a, b) => a.localeCompare(b, "en", { numeric: true }))
    .map((file) => ({ group, name: basename(file).replace(/\.\w+$/, ""), file, text: text(root, folder, file) })));
  const problems = await read(examples);
  const opened = examples.map(({ group, name }, i) => ({ group, name, problem: problems[i] }));
  return `export const examples = ${JSON.stringify(opened)};\n`;
}

/** The problems in some files, each {file, text}. */
async function read(files) {
  const worker = new Worker(join(engine, "worker.js"));
  const problems = [];
  await new Promise((resolve, reject) => {
    worker.on("error", reject);
    worker.on("message", ({ kind, id, problem, message }) => {
      if (kind === "error") reject(new Error(`${files[id].file}: ${message}`));
      if (kind !== "result") return;
      problems[id] = problem;
      if (id === files.length - 1) resolve();
    });
    files.forEach(({ file, text }, id) => worker.postMessage({ id, kind: "read", name: file, text }));
  });
  await worker.terminate();
  return problems;
}

const virtual = { player: playerModule, examples: examplesModule };

const virtualModules = {
  name: "virtual",
  setup(builder) {
    builder.onResolve({ filter: /^(player|examples)$/ }, ({ path }) => ({ path, namespace: "virtual" }));
    builder.onLoad({ filter: /.*/, namespace: "virtual" }, async ({ path }) => ({ contents: await virtual[path](), resolveDir: here }));
  },
};

async function script() {
  const result = await build({
    entryPoints: [join(here, "page/main.js")], bundle: true, format: "esm", minify: true, write: false, charset: "utf8",
    target: "es2022", plugins: [virtualModules], logLevel: "warning",
  });
  return result.outputFiles[0].text.replaceAll("</script", "<\\/script");
}

/** What runs at once: a worker of a text in the page, and the engine that is sent to it. */
function engineElements() {
  const worker = text(engine, "engine.js") + text(engine, "worker.js");
  if (/<\/?script|<!--/i.test(worker)) throw new Error("the worker would end the element that it stands in");
  const bytes = gzipSync(readFileSync(join(engine, "engine.wasm")), { level: 9 }).toString("base64");
  return [
    `<script id="worker" type="text/plain">\n${worker}</script>`,
    `<script>\n${text(here, "page/plan/first_worker.js")}</script>`,
    `<script id="engine" type="text/plain">${bytes}</script>`,
    `<script>\n${text(here, "page/plan/engine_bytes.js")}</script>`,
  ].join("\n");
}

/** A group of the player's controls, as its page has them. */
const controls = (name) => text(root, "io/player/page/player.html").match(new RegExp(`<div class="${name}"[^]*?</div>`))[0];

const parts = {
  TRANSPORT: controls("transport"),
  ZOOM: controls("zoom"),
  STYLE: text(root, "io/player/page/player.css") + text(here, "page/style.css"),
  ENGINE: engineElements(),
  SCRIPT: await script(),
};
const page = text(here, "page/index.html").replace(/@([A-Z]+)@/g, (_, name) => parts[name]);
writeFileSync(join(out, "asv-playground.html"), page);
console.log(`${join(out, "asv-playground.html")}: ${(page.length / 1e6).toFixed(2)} MB`);
