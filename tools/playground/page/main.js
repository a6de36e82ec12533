// Starts the playground: joins the model, the engine, the editor and the view.

import { stage, story, shown as looks, watchStage } from "player";
import { examples } from "examples";
import { Editor } from "./edit/editor.js";
import { paintHandles, paintMark } from "./edit/handles.js";
import { Inspector } from "./edit/inspector.js";
import { Keys, nameOf } from "./edit/keys.js";
import { Marks } from "./edit/marks.js";
import { Files } from "./files/files.js";
import { toHash, wishesOf } from "./files/share.js";
import { boundsOf, removeBox } from "./model/edits.js";
import { Model } from "./model/model.js";
import { Engine } from "./plan/engine.js";
import { Planning } from "./plan/planning.js";
import { loadWorker } from "./plan/worker_source.js";
import { announce, notice } from "./show/notice.js";
import { watchPlayback } from "./show/playback.js";
import { writeVerdict, writeViolations } from "./show/verdict.js";
import { makePlots, View } from "./show/view.js";

const by = (id) => document.getElementById(id);

const firstExample = "7ASV";
const gridShares = [0, 0.01, 0.02, 0.05];

const model = new Model();
const startWorker = await loadWorker();
const engine = new Engine(startWorker);
const view = new View();
const marks = new Marks(engine, (lines) => {
  writeViolations(lines);
  view.paintEdit();
});

/** Shows what planning has: one problem with its own path, or with none. */
function present(shown, done = false) {
  const headline = writeVerdict(shown, done);
  if (shown.state !== "planning") announce(headline);
  view.tell(shown.problem, shown.state === "solved" ? shown.answer.states : null);
  if (shown.state === "invalid ends") marks.look(shown.problem);
  else if (!editor.drag) marks.look(null);
  if (shown.state === "solved" && !editor.drag) measure(shown);
}

/** Asks for the measures of the path on show, unless another one has come since. */
async function measure({ problem, version, answer }) {
  const measures = await engine.ask("profile", { problem, states: answer.states.slice() });
  if (planning.shown.version === version && planning.shown.answer === answer && measures.cost) view.measure(measures);
}

const planning = new Planning(engine, model, present);
const editor = new Editor(model, (end, wished) => marks.look(wished, [end]));
const keys = new Keys(model, editor, announce);

function watchTools() {
  by("draw").addEventListener("click", () => editor.setDrawing(!editor.drawing));
  by("delete").addEventListener("click", () => keys.remove());
  by("undo").addEventListener("click", () => model.undo());
  by("redo").addEventListener("click", () => model.redo());
  for (const share of gridShares) by("grid").add(new Option(share ? `${100 * share} %` : "off", share));
  by("grid").addEventListener("change", () => {
    const [low, high] = boundsOf(model.problem) ?? [[0, 0], [1, 1]];
    editor.grid = Number(by("grid").value) * Math.max(high[0] - low[0], high[1] - low[1]);
  });
  for (const name of ["trails", "numbers"]) {
    by(`show-${name}`).addEventListener("change", (event) => {
      looks[name] = event.target.checked;
      view.paint({ ground: true });
    });
  }
  by("share").addEventListener("click", share);
}

async function share() {
  const address = new URL(location.href);
  address.hash = await toHash(model.problem);
  by("link").value = address.href;
  history.replaceState(null, "", address.hash);
  try {
    await navigator.clipboard.writeText(address.href);
    notice("The link is copied.");
  } catch {
    by("link").select(); // a page from disk may not write to the clipboard
    notice("The link stands in its field, ready to be copied.");
  }
}

async function openExample(name) {
  const example = examples.find((candidate) => candidate.name === name);
  const { problem } = await engine.ask("read", { name: example.file, text: example.text });
  model.open(problem, name);
}

async function fillLists() {
  for (const { group, name } of examples) {
    let place = [...by("example").children].find((child) => child.label === group);
    if (!place) {
      place = document.createElement("optgroup");
      place.label = group;
      by("example").append(place);
    }
    place.append(new Option(name, name));
  }
  by("example").value = firstExample;
  by("example").addEventListener("change", () => openExample(by("example").value));
  const { planners } = await engine.ask("planners");
  for (const { name, summary } of planners) {
    const option = new Option(name, name);
    option.title = summary;
    by("planner").append(option);
  }
  by("planner").value = "auto";
  by("planner").addEventListener("change", () => planning.restart(by("planner").value));
  return planners;
}

/** The problem that the address holds, or the first example. */
async function openFirst() {
  try {
    const { problem } = await wishesOf(location.hash);
    if (problem) {
      await engine.ask("check", { problem });
      return model.open(problem, "shared");
    }
  } catch (error) {
    notice(`The link holds no problem: ${error.message}`, true);
  }
  await openExample(firstExample);
}

async function start() {
  makePlots();
  view.extra.push((context) => model.problem && story.start && paintHandles(context, model.selection),
                  (context) => marks.marks.forEach((mark) => paintMark(context, mark)));
  watchStage();
  watchTools();
  new Inspector(model);
  watchPlayback({ show: () => view.paint(), announce: (step, last) => announce(`Step ${step} of ${last}`) });
  model.onChange(() => view.paintEdit());
  new Files(engine, model, {
    path: () => (planning.shown.state === "solved" ? planning.shown.answer.states : null),
    showPath: () => {}, say: notice,
  });
  await engine.ready;
  await openFirst();
  view.watch();
  await fillLists();
}

window.addEventListener("hashchange", openFirst);
window.playground = { model, planning, engine, view, editor };
start().catch((error) => notice(`The playground does not start: ${error.message}`, true));
