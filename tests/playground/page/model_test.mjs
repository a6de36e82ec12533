// The parts of the editor that need no page: how chains move, what can be undone, links.

import assert from "node:assert/strict";
import { test } from "node:test";
import { arc, bodyPoints, centreOf, headingsOf, pulled, signedArea, turned, turnsOf, withTurns } from "../../../tools/playground/page/model/kinematics.js";
import { Model } from "../../../tools/playground/page/model/model.js";
import { fromHash, toHash, wishesOf } from "../../../tools/playground/page/files/share.js";

const lengths = (points) => headingsOf(points).map((_, i) => Math.hypot(points[2 * i + 2] - points[2 * i], points[2 * i + 3] - points[2 * i + 1]));

/** Numbers in [0, 1) that are the same in every run (Park and Miller 1988). */
function randomFrom(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

test("brooms keep their length, whatever is pulled where", () => {
  const random = randomFrom(7);
  for (let trial = 0; trial < 200; ++trial) {
    const count = 2 + Math.floor(29 * random());
    const chain = arc(count, [random(), random()], 6 * random(), 3 * random(), 0.05);
    const index = Math.floor(count * random());
    const [x, y] = [random(), random()];
    const result = pulled(chain, index, x, y, 0.05);
    assert.deepEqual(result.slice(2 * index, 2 * index + 2), [x, y], `trial ${trial}`);
    for (const length of lengths(result)) assert.ok(Math.abs(length - 0.05) < 1e-12, `trial ${trial}: ${length}`);
  }
});

test("a chain has the turns that it is given, and its fixed point stays", () => {
  const chain = arc(7, [0.5, 0.5], 0.3, 2, 0.05);
  const wanted = [0.1, 0.2, 0.3, 0.4, 0.5];
  for (let fixed = 0; fixed < 7; ++fixed) {
    const result = withTurns(chain, wanted, 0.05, fixed);
    turnsOf(result).forEach((turn, i) => assert.ok(Math.abs(turn - wanted[i]) < 1e-9, `turn ${i}, fixed ${fixed}: ${turn}`));
    for (const axis of [0, 1]) assert.equal(result[2 * fixed + axis], chain[2 * fixed + axis]);
  }
});

test("an arc has its centre, its sense and its roundness; turning it moves no centre", () => {
  for (const total of [1, -1, 4, -4]) {
    const points = arc(9, [0.4, 0.6], 1, total, 0.05);
    assert.ok(Math.abs(turnsOf(points).reduce((sum, turn) => sum + turn) - total) < 1e-9);
    assert.equal(Math.sign(signedArea(points)), Math.sign(total));
    for (const place of [points, turned(points, 2)]) {
      const [x, y] = centreOf(place);
      assert.ok(Math.abs(x - 0.4) < 1e-9 && Math.abs(y - 0.6) < 1e-9);
    }
  }
});

test("an arm's joints follow from its angles, relative or absolute", () => {
  const body = { kind: "arm", base: [1, 2], links: [3, 2], joints: "wrap" };
  const near = (points, wanted) => points.forEach((value, i) => assert.ok(Math.abs(value - wanted[i]) < 1e-12, String(points)));
  near(bodyPoints({ body: { ...body, angles: "relative" } }, [Math.PI / 2, -Math.PI / 2]), [1, 2, 1, 5, 3, 5]);
  near(bodyPoints({ body: { ...body, angles: "absolute" } }, [Math.PI / 2, -Math.PI / 2]), [1, 2, 1, 5, 1, 3]);
});

test("one drag is one step of undo, and an edit ends what could be redone", () => {
  const model = new Model();
  model.open({ start: 0 }, "first");
  const set = (value) => model.edit((problem) => ({ ...problem, start: value }));
  set(1);
  model.hold();
  for (const value of [2, 3, 4]) set(value);
  model.release();
  assert.equal(model.problem.start, 4);
  model.undo();
  assert.equal(model.problem.start, 1);
  model.redo();
  assert.equal(model.problem.start, 4);
  model.undo();
  model.undo();
  assert.equal(model.problem.start, 0);
  set(9);
  model.redo();
  assert.equal(model.problem.start, 9);
  const { version } = model;
  model.edit((problem) => problem);
  assert.equal(model.version, version, "an edit that changes nothing is none");
});

test("a link holds every digit", async () => {
  const problem = { version: 1, body: { kind: "point" }, start: [0.1, 1 / 3], goal: [1e-17, 2 ** -40], name: "\u00fc" };
  const hash = await toHash(problem);
  assert.match(hash, /^p=[\w-]+$/);
  assert.deepEqual(await fromHash(hash), problem);
  assert.deepEqual((await wishesOf({ hash: `#lesson=rrt&${hash}`, search: "" })).problem, problem);
  assert.equal((await wishesOf({ hash: "", search: "?lesson=rrt&step=4" })).step, "4");
  await assert.rejects(fromHash("p=nonsense"));
});
