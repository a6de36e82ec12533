// The planner and the validator in a worker: messages in, messages out, in order.
//
// Page -> worker {id, kind, ...}; worker -> page {id, kind: "result" | "progress" | "error", ...}. An error has a
// message and, where text was read, its line and column. A problem is the JSON object of docs/scenario.md (no map, whose rectangles are obstacles). States are a
// Float64Array, one state after the other, each x1 y1 x2 y2 ... in chain order (of an arm: all joints, the base first).
// Arrays of an answer are transferred. Before all else the worker says {kind: "ready", version, simd}; one that is made of a
// text waits for {kind: "engine", bytes}, a gzipped engine.wasm, before that.
//
//   check    {problem}           -> {start: [violation], goal: [violation], minimumArea, infeasible: null | text}
//                                   violation: {requirement, text, asv, broom, obstacle}, numbers from 1, or null
//   plan     {problem, planner, settings: {key: value}, seed, optimize, timeLimit, warm: states | null, trees: bool,
//             bound: bool, progress: bool, slot}
//                                -> {status, reason, cost, bound, seconds: {first, total}, states, valid, violation,
//                                    history: [[seconds, cost]], trees: null | {start: tree, goal: tree}}
//                                   status: "solved", "not found", "infeasible", "invalid ends" or "interrupted";
//                                   tree: {points: states (of ASV 1, the tip or the point), parents: Int32Array};
//                                   a roadmap is {start: tree without parents, edges: pairs of nodes, one after the other}
//                                   with progress, {cost, states} after each slice that found a better path
//   validate {problem, states}   -> {valid, checks: [{name, ok, text}], cost}
//   profile  {problem, states}   -> {clearance, area, turn, cost}: Float64Arrays, one number for each state
//   planners {}                  -> {planners: [{name, summary, source, settings: [{key, meaning, unit, min, max, default}]}]}
//   read     {name, text, problem, files: {name: bytes}} -> {problem, states | null, maps: [name]}
//                                   the problem is needed for a solution file; files are those that a scenario may name, the
//                                   bytes of each as characters U+0000 to U+00FF; maps are those that it does
//   write    {what: "problem" | "scenario" | "solution", problem, states} -> {name, text}
//
// optimize and timeLimit are seconds. A plan is warm-started from the states of `warm`, a path of a problem like this one.
// bound: false leaves out the lower bound, which has no place while something is dragged (null in the answer).
// Latest wins: a plan that waits is given up ("interrupted") when another one of the same slot arrives, and one that is
// being improved in slices (progress: true) ends with the best path it has.
"use strict";

// In a browser this is a worker, under node (in tests) a worker thread.
const inNode = typeof process === "object" && typeof importScripts === "undefined";
const port = inNode ? require("node:worker_threads").parentPort : self;

// A page that is one file makes the worker of a text, engine.js before this one, and sends the engine itself in a message.
const madeOfText = !inNode && location.protocol === "blob:";

/** The engine from the file beside this one. */
async function engineFile() {
  if (inNode) return require("node:fs").readFileSync(`${__dirname}/engine.wasm`);
  return (await fetch("engine.wasm")).arrayBuffer();
}

function engineFactory() {
  if (inNode) return require("./engine.js");
  if (!madeOfText) importScripts("engine.js");
  return createEngine;
}

/** The engine from its gzipped bytes, compiled while they are unpacked. */
function unpacked(bytes) {
  const gunzip = new DecompressionStream("gzip");
  const writer = gunzip.writable.getWriter();
  writer.write(bytes);
  writer.close();
  const wasm = new Response(gunzip.readable, { headers: { "Content-Type": "application/wasm" } });
  return new Promise((resolve, reject) => {
    const instantiateWasm = (imports, receive) => {
      WebAssembly.instantiateStreaming(wasm, imports).then(({ instance }) => receive(instance), reject);
      return {};
    };
    engineFactory()({ instantiateWasm }).then(resolve, reject);
  });
}

/** Sets a member by its path, "trees.start.points". */
function setMember(object, path, value) {
  const names = path.split(".");
  const last = names.pop();
  for (const name of names) object = object[name] ??= {};
  object[last] = value;
}

/** One call of the engine: the answer with its arrays as members. */
function call(engine, request, states) {
  const text = JSON.stringify(request);
  const size = engine.lengthBytesUTF8(text) + 1;
  const json = engine._malloc(size);
  engine.stringToUTF8(text, json, size);
  const count = states ? states.length : 0;
  const numbers = engine._malloc(8 * count + 8);
  if (states) engine.HEAPF64.set(states, numbers / 8);
  const answer = engine._asv_call(json, numbers, count);
  engine._free(json);
  engine._free(numbers);
  const { arrays = [], ...result } = JSON.parse(engine.UTF8ToString(engine._asv_text(answer)));
  arrays.forEach(([member, length], index) => {
    const begin = engine._asv_array(answer, index) / 8;
    const array = engine.HEAPF64.slice(begin, begin + length);
    setMember(result, member, member.endsWith("parents") ? Int32Array.from(array) : array);
  });
  engine._asv_free(answer);
  return result;
}

/** All buffers in an answer, which are given away with it. */
function buffersOf(value, found = []) {
  if (ArrayBuffer.isView(value)) found.push(value.buffer);
  else if (value && typeof value === "object") Object.values(value).forEach((member) => buffersOf(member, found));
  return found;
}

function send(message) {
  port.postMessage(message, buffersOf(message));
}

const interrupted = {
  status: "interrupted", reason: "a newer message took its place", cost: null, bound: null,
  seconds: { first: 0, total: 0 }, states: null, valid: false, violation: null, history: [], trees: null,
};

/** Messages in order; of plans that wait in one slot the newest alone. */
const queue = [];

function enqueue(message) {
  if (message.kind === "plan" && message.slot !== undefined) {
    const older = queue.findIndex((waiting) => waiting.kind === "plan" && waiting.slot === message.slot);
    if (older >= 0) send({ id: queue.splice(older, 1)[0].id, kind: "result", ...interrupted });
  }
  queue.push(message);
  wake();
}

let wake = () => {};

/** Lets messages that have come in meanwhile enter the queue. */
function breathe() {
  return new Promise((resolve) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => {
      channel.port1.close();
      resolve();
    };
    channel.port2.postMessage(null);
  });
}

// Seconds of improvement in one slice, between two looks at the queue.
const sliceOfWork = 0.1;

function isOutdated(message) {
  return queue.some((waiting) => waiting.kind === "plan" && waiting.slot === message.slot);
}

/** A plan in slices: the first path at once, then improvement as long as it was asked for and nothing newer waits. */
async function planInSlices(engine, message) {
  const begin = performance.now();
  const secondsLeft = () => (message.timeLimit ?? 60) - (performance.now() - begin) / 1000;
  const request = { ...message, warm: undefined, optimize: 0 };
  let best = call(engine, request, message.warm);
  let seed = message.seed ?? 1;
  const history = best.history ?? [];
  for (let work = message.optimize ?? 0; work > 0 && best.states && secondsLeft() > 0; work -= sliceOfWork) {
    send({ id: message.id, kind: "progress", cost: best.cost, states: best.states.slice() });
    await breathe();
    if (isOutdated(message)) break;
    const slice = { optimize: Math.min(work, sliceOfWork), timeLimit: secondsLeft(), seed: ++seed, trees: false };
    const better = call(engine, { ...request, ...slice }, best.states);
    if (!better.states || better.cost >= best.cost) continue;
    history.push([(performance.now() - begin) / 1000, better.cost]);
    best = { ...better, trees: best.trees, seconds: { ...better.seconds, first: best.seconds.first }, history };
  }
  if (best.seconds) best.seconds.total = (performance.now() - begin) / 1000;
  return best;
}

async function answer(engine, message) {
  if (message.kind === "plan" && message.progress) return planInSlices(engine, message);
  const { states, warm, ...request } = message;
  return call(engine, request, states ?? warm);
}

async function serve(engine) {
  for (;;) {
    if (queue.length === 0) await new Promise((resolve) => (wake = resolve));
    await breathe();
    const message = queue.shift();
    if (!message) continue;
    try {
      const result = await answer(engine, message);
      if (result.error) send({ id: message.id, kind: "error", ...result.error });
      else send({ id: message.id, kind: "result", ...result });
    } catch (failure) {
      send({ id: message.id, kind: "error", message: String(failure), line: null, column: null });
    }
  }
}

async function start() {
  let receiveEngine;
  const engineSent = new Promise((resolve) => (receiveEngine = resolve));
  const receive = (message) => (message.kind === "engine" ? receiveEngine(message.bytes) : enqueue(message));
  if (inNode) port.on("message", receive);
  else port.onmessage = (event) => receive(event.data);
  const engine = madeOfText ? await unpacked(await engineSent) : await engineFactory()({ wasmBinary: await engineFile() });
  send({ kind: "ready", version: engine.UTF8ToString(engine._asv_version()), simd: true });
  await serve(engine);
}

start();
