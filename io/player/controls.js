// The player: which step is shown, what moves it, and the figures beside the field.

const by = (id) => document.getElementById(id);

const last = story.lastStep;
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

/** position is a step of the path with its fraction; direction is 1, -1, or 0 while paused. */
const playing = { position: 0, direction: 0, speed: 1, before: 0 };

const plots = makePlots();

/** The index of the state that is shown. */
const now = () => stateNear(Math.round(playing.position));

const grouped = (number) => number.toLocaleString("en-US");

/** The speed 1 takes 20 seconds for the whole path, within what the eye can follow. */
const stepsPerSecond = () => clamp(last / 20, 30, 1500) * playing.speed;

function fillSpeeds() {
  for (const speed of [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8, 16]) {
    by("speed").add(new Option(`${speed}\u00d7`, speed, false, speed === (reducedMotion.matches ? 0.25 : 1)));
  }
  playing.speed = Number(by("speed").value);
}

function describeViolations(state) {
  return (story.violated.get(state) || []).map((v) => `${v.check}: ${v.sentence}`);
}

function put(id, text) {
  const element = by(id);
  if (element.textContent !== text) element.textContent = text;
}

/** "broom 3, obstacle 2": which two are nearest to each other, in the words of the body. */
function nearestPair(state) {
  const link = story.words.link === "" ? "" : `${story.words.link} ${story.clearanceBroom[state] + 1}, `;
  return `${link}obstacle ${story.clearanceObstacle[state] + 1}`;
}

function writeReadouts(state) {
  put("out-step", grouped(story.steps[state]));
  put("out-cost", story.cost[state].toFixed(4));
  const clearance = story.clearance[state];
  put("out-clearance", Number.isFinite(clearance) ? clearance.toFixed(6) : "none");
  put("at-clearance", Number.isFinite(clearance) ? `${nearestPair(state)}, minimum 0` : "no obstacles");
  if (story.body === "chain") put("out-area", story.area[state].toFixed(6));
  const turn = story.turn[state];
  put("out-turn", Number.isFinite(turn) ? `${((turn * 180) / Math.PI).toFixed(1)}\u00b0` : "none");
  put("at-turn", Number.isFinite(turn) ? `at ASV ${story.turnAsv[state] + 1}, maximum 180\u00b0` : "");
  const violations = story.violated.get(state) || [];
  const failed = (...checks) => violations.some((v) => checks.includes(v.check));
  by("out-clearance").classList.toggle("bad", failed("collisions"));
  by("out-area").classList.toggle("bad", failed("area"));
  by("out-turn").classList.toggle("bad", failed("convexity"));
  if (!story.valid) {
    const here = describeViolations(state);
    put("alarm-here", here.length === 0 ? "None in this step." : `\u2717 In this step: ${here.join("; ")}.`);
    by("alarm-here").classList.toggle("bad", here.length > 0);
  }
}

function writeTotals() {
  put("of-steps", `of ${grouped(last)}`);
  by("held").hidden = story.states === last + 1;
  put("held", `This page holds ${grouped(story.states)} of ${grouped(last + 1)} states: of each short stretch of the path the ` +
    "first one and those with the least clearance, the least area, the tightest turn and a violation.");
  put("of-cost", `of ${story.totalCost.toFixed(4)}`);
  put("of-area", `minimum ${story.minimumArea.toFixed(6)}`);
  // Only ASVs have requirements on their shape.
  for (const id of ["out-area", "out-turn"]) by(id).closest("div").hidden = story.body !== "chain";
}

function show({ ground = false } = {}) {
  const state = now();
  if (ground) paintGround();
  paintTrail(state, ground);
  paintNow(state);
  if (story.states === 0) return;
  for (const plot of plots) plot.paint(state);
  writeReadouts(state);
  by("scrub").value = story.steps[state];
  by("scrub").setAttribute("aria-valuetext", `step ${grouped(story.steps[state])} of ${grouped(last)}`);
}

/** For those who hear the page; never while playing, or it would not stop talking. */
function announce() {
  const state = now();
  put("announce", [`Step ${grouped(story.steps[state])} of ${grouped(last)}`, `cost ${story.cost[state].toFixed(4)}`,
    ...describeViolations(state)].join(", "));
}

function writePlaying() {
  const forward = playing.direction > 0;
  by("playback").classList.toggle("playing", forward);
  by("play").setAttribute("aria-label", forward ? "Pause" : "Play");
  by("rewind").setAttribute("aria-pressed", String(playing.direction < 0));
}

function pause() {
  playing.direction = 0;
  writePlaying();
  announce();
}

function play(direction) {
  if (last === 0) return;
  if (direction > 0 && playing.position >= last) playing.position = 0;
  if (direction < 0 && playing.position <= 0) return;
  playing.direction = direction;
  playing.before = performance.now();
  writePlaying();
  requestAnimationFrame(advance);
}

function advance(time) {
  if (playing.direction === 0) return;
  // A tab that was away for long goes on where it was, not seconds later.
  const seconds = clamp((time - playing.before) / 1000, 0, 0.1);
  playing.before = time;
  const next = playing.position + playing.direction * seconds * stepsPerSecond();
  playing.position = clamp(next, 0, last);
  show();
  if (playing.position === next) requestAnimationFrame(advance);
  else pause();
}

const toggle = (direction) => (playing.direction === direction ? pause() : play(direction));

/** Shows one state, by its index, and stays there. */
function goToState(state) {
  if (story.states === 0) return;
  playing.position = story.steps[clamp(state, 0, story.states - 1)];
  show();
  pause();
}

/** Shows one step, or the nearest to it that the page holds. */
const goTo = (step) => goToState(stateNear(clamp(step, 0, last)));

/** The bar has all steps: one move of it leads to another state, also where steps are left out. */
function followBar() {
  const step = Number(by("scrub").value);
  const state = stateNear(step);
  goToState(state === now() ? state + Math.sign(step - story.steps[state]) : state);
}

const commands = {
  "to-start": () => goTo(0),
  "rewind": () => toggle(-1),
  "step-back": () => goToState(now() - 1),
  "play": () => toggle(1),
  "step-on": () => goToState(now() + 1),
  "to-end": () => goTo(last),
};

const keysEverywhere = { " ": "play", ArrowLeft: "step-back", ArrowRight: "step-on", Home: "to-start", End: "to-end" };

const keysInStage = { "+": () => zoomCentre(1.5), "=": () => zoomCentre(1.5), "-": () => zoomCentre(1 / 1.5), 0: fit };

const pans = { ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60] };

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const inStage = event.target === stage;
  const inControl = event.target.closest("button, select, summary, input");
  // A control keeps the keys that it has a use for; the bar understands all but the space itself.
  if (inControl && (event.target.id !== "scrub" || event.key !== " ") &&
      (event.key === " " || inControl.matches("select, [type=range]"))) return;
  if (inStage && event.shiftKey && pans[event.key]) pan(...pans[event.key]);
  else if (inStage && keysInStage[event.key]) keysInStage[event.key]();
  else if (!event.shiftKey && keysEverywhere[event.key]) commands[keysEverywhere[event.key]]();
  else return;
  event.preventDefault();
}

function watchControls() {
  for (const [id, command] of Object.entries(commands)) {
    by(id).addEventListener("click", (event) => {
      command();
      // After a click of the mouse the space bar plays, instead of pressing this button again.
      if (event.detail > 0) stage.focus({ preventScroll: true });
    });
  }
  by("scrub").addEventListener("input", followBar);
  by("speed").addEventListener("change", () => { playing.speed = Number(by("speed").value); });
  for (const name of ["trails", "trees", "numbers"]) {
    by(`show-${name}`).addEventListener("change", (event) => {
      shown[name] = event.target.checked;
      show({ ground: true });
    });
  }
  document.addEventListener("keydown", onKey);
}

function writeAlarm() {
  by("alarm").hidden = story.complaints.length === 0;
  const listed = story.violations.length;
  by("unlisted").hidden = listed === story.violationCount;
  put("unlisted", `Marked are ${grouped(listed)} of ${grouped(story.violationCount)} violations.`);
  for (const { check, sentence, step } of story.complaints) {
    const item = document.createElement("li");
    const place = story.states === 0 || step === null ? item : document.createElement("button");
    const name = document.createElement("b");
    name.textContent = `\u2717 ${check}: `;
    place.append(name, sentence);
    if (place !== item) {
      place.type = "button";
      place.append(` (step ${grouped(step)})`);
      place.addEventListener("click", () => goTo(step));
      item.append(place);
    }
    by("complaints").append(item);
  }
}

function writePage() {
  put("facts", story.facts);
  put("verdict", `${story.valid ? "\u2713" : "\u2717"} ${story.verdict}`);
  by("verdict").classList.toggle("bad", !story.valid);
  by("trees-toggle").hidden = story.trees.length === 0;
  by("scrub").max = last;
  writeAlarm();
  writeLegend();
  fillSpeeds();
  if (story.states === 0) {
    const useless = document.querySelectorAll("#playback, #trails-toggle, #readouts, #plots, .when-solved");
    for (const element of useless) element.hidden = true;
    by("no-solution").hidden = false;
  } else {
    writeTotals();
  }
}

function resize() {
  const size = stage.clientWidth;
  if (size === 0) return;
  camera.size = size;
  readColours();
  for (const plot of plots) plot.resize();
  paintMarks();
  show({ ground: true });
}

writePage();
watchStage();
watchControls();
camera.onChange = () => requestGround();

/** Several changes of the view between two frames are painted once. */
let groundAsked = false;
function requestGround() {
  if (groundAsked) return;
  groundAsked = true;
  requestAnimationFrame(() => {
    groundAsked = false;
    show({ ground: true });
  });
}

[camera.x, camera.y] = fieldCentre();
new ResizeObserver(resize).observe(stage);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", resize);
resize();
