// The player: the figures beside the field, and what the buttons and keys do.

const plots = makePlots();

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
  put("of-steps", `of ${grouped(lastStep())}`);
  by("held").hidden = story.states === lastStep() + 1;
  put("held", `This page holds ${grouped(story.states)} of ${grouped(lastStep() + 1)} states: of each short stretch of the path the ` +
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
  by("scrub").setAttribute("aria-valuetext", `step ${grouped(story.steps[state])} of ${grouped(lastStep())}`);
}

/** For those who hear the page; never while playing, or it would not stop talking. */
function announce() {
  const state = now();
  put("announce", [`Step ${grouped(story.steps[state])} of ${grouped(lastStep())}`, `cost ${story.cost[state].toFixed(4)}`,
    ...describeViolations(state)].join(", "));
}

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
  by("scrub").max = lastStep();
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
