// Joins the page of the playground, its style and the player's scripts into files that a browser
// opens: bundle.mjs ENGINE OUT, with the npm packages of package.json in OUT/npm.
//
// ENGINE is the folder of the built engine, with asv-worker.js; OUT gets asv-playground.html, all in one file.

import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

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

/** Problems that are opened by name: those of testcases/, and some of the playground's own. */
function examplesModule() {
  const groups = [["Chains", "testcases"], ["Without a path", "testcases/infeasible"], ["Other bodies", "tools/playground/examples"]];
  const examples = groups.flatMap(([group, folder]) => readdirSync(join(root, folder))
    .filter((file) => /\.(txt|json)$/.test(file))
    .sort((a, b) => a.localeCompare(b, "en", { numeric: true }))
    .map((file) => ({ group, file, name: basename(file).replace(/\.\w+$/, ""), text: text(root, folder, file) })));
  return `export const examples = ${JSON.stringify(examples)};\n`;
}

const virtual = { player: playerModule, examples: examplesModule };

const virtualModules = {
  name: "virtual",
  setup(builder) {
    builder.onResolve({ filter: /^(player|examples)$/ }, ({ path }) => ({ path, namespace: "virtual" }));
    builder.onLoad({ filter: /.*/, namespace: "virtual" }, ({ path }) => ({ contents: virtual[path](), resolveDir: here }));
  },
};

async function script() {
  const result = await build({
    entryPoints: [join(here, "page/main.js")], bundle: true, format: "esm", minify: true, write: false, charset: "utf8",
    target: "es2022", plugins: [virtualModules], logLevel: "warning",
  });
  return result.outputFiles[0].text.replaceAll("</script", "<\\/script");
}

/** The worker with the engine in it, as a text of the page that is run by the page's script alone. */
function engineText() {
  const worker = text(engine, "asv-worker.js");
  if (/<\/?script|<!--/i.test(worker)) throw new Error("asv-worker.js would end the element that it stands in");
  return `<script id="engine" type="text/plain">\n${worker}</script>`;
}

/** A group of the player's controls, as its page has them. */
const controls = (name) => text(root, "io/player/page/player.html").match(new RegExp(`<div class="${name}"[^]*?</div>`))[0];

const parts = {
  TRANSPORT: controls("transport"),
  ZOOM: controls("zoom"),
  STYLE: text(root, "io/player/page/player.css") + text(here, "page/style.css"),
  ENGINE: engineText(),
  SCRIPT: await script(),
};
const page = text(here, "page/index.html").replace(/@([A-Z]+)@/g, (_, name) => parts[name]);
writeFileSync(join(out, "asv-playground.html"), page);
console.log(`${join(out, "asv-playground.html")}: ${(page.length / 1e6).toFixed(2)} MB`);
