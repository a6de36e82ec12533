// The engine and the programs over all test cases: asv-validate accepts what the engine exports, and the same problem and
// seed give the same file.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Engine, run, testcases } from "./engine.mjs";

const seed = 1;
const folder = mkdtempSync(join(tmpdir(), "asv-playground-"));
let engine;
before(() => (engine = new Engine()));
after(async () => {
  await engine.close();
  rmSync(folder, { recursive: true });
});

const isProblem = (name) => name.endsWith(".txt") || name.endsWith(".json");
const filesIn = (path) => readdirSync(path).filter(isProblem).map((name) => join(path, name));

for (const file of [...filesIn(testcases), ...filesIn(join(testcases, "bodies"))])
  test(file.slice(testcases.length + 1), async (t) => {
    const { problem } = await engine.read(file);
    const planned = await engine.ask("plan", { problem, planner: "auto", seed, optimize: 0, timeLimit: 120 });
    assert.equal(planned.status, "solved", planned.reason ?? planned.message);
    assert.ok(planned.valid, planned.violation);
    const written = await engine.ask("write", { what: "solution", problem, states: planned.states });
    const ours = join(folder, "wasm.txt"), native = join(folder, "native.txt");
    writeFileSync(ours, written.text);
    run("asv-validate", file, ours, "--continuous", "--quiet");
    run("asv-solve", file, native, "--seed", String(seed), "--threads", "1", "--optimize", "0", "--quiet");
    const nativeText = readFileSync(native, "utf8");
    const nativeCost = nativeText.split("\n", 1)[0].split(" ")[1];
    const milliseconds = (1000 * planned.seconds.first).toFixed(1);
    t.diagnostic(`first path after ${milliseconds} ms, cost ${planned.cost}, native ${nativeCost}`);
    assert.ok(written.text === nativeText, "the files differ");
  });

test("The same seed gives the same path, in every engine", async () => {
  const { problem } = await engine.read(join(testcases, "7ASV.txt"));
  const order = { problem, seed, optimize: 0.1, timeLimit: 120 };
  const other = new Engine();
  const [once, twice, elsewhere] = await Promise.all([engine, engine, other].map((one) => one.ask("plan", order)));
  await other.close();
  assert.deepEqual(twice.states, once.states);
  assert.deepEqual(elsewhere.states, once.states);
});

test("A problem and a scenario are written as they were read", async () => {
  const { problem } = await engine.read(join(testcases, "7ASV.txt"));
  for (const what of ["problem", "scenario"]) {
    const { text } = await engine.ask("write", { what, problem });
    const again = await engine.ask("read", { name: what, text });
    assert.deepEqual(again.problem, problem);
  }
});

test("Numbers have the shortest digits that read back to them", async () => {
  const { problem } = await engine.read(join(testcases, "3ASV.txt"));
  problem.obstacles = [[[0.1, 0.30000000000000004], [0.5, 1e-7 + 0.5]]];
  const { text } = await engine.ask("write", { what: "problem", problem });
  assert.equal(text.split("\n")[4], "0.1 0.30000000000000004 0.5 0.30000000000000004 0.5 0.5000001 0.1 0.5000001");
});
