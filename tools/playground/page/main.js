// Starts the page: the playground, or one picture of a lesson where the address asks for it.

import { shown as looks, stage, story, watchStage } from "player";
import { examples } from "examples";
import { Editor } from "./edit/editor.js";
import { hit, paintHandles, paintMark, pixelsOf } from "./edit/handles.js";
import { Inspector } from "./edit/inspector.js";
import { Keys } from "./edit/keys.js";
import { Marks } from "./edit/marks.js";
import { wishesOf } from "./files/share.js";
import { boundsOf } from "./model/edits.js";
import { Model } from "./model/model.js";
import { Engine } from "./plan/engine.js";
import { startWorker } from "./plan/worker_source.js";
import { startPlayground } from "./playground.js";
import { startLesson } from "./show/lesson.js";
import { announce, notice } from "./show/notice.js";
import { watchPlayback } from "./show/playback.js";
import { writeViolations } from "./show/verdict.js";
import { makePlots, View } from "./show/view.js";

const by = (id) => document.getElementById(id);

const firstExample = "7ASV";
const gridShares = [0, 0.01, 0.02, 0.05];

/** What every part of the page works with. */
function makeParts() {
  const [model, engine, view] = [new Model(), new Engine(startWorker), new View()];
  const marks = new Marks(engine, (lines) => {
    writeViolations(lines);
    view.paintEdit();
  });
  const editor = new Editor(model, (end, wished) => marks.look(wished, [end]));
  const keys = new Keys(model, editor, announce);
  view.extra.push((context) => paintHandles(context, model.selection),
                  (context) => marks.marks.forEach((mark) => paintMark(context, mark)));
  model.onChange(() => view.paintEdit());
  return { model, engine, view, marks, editor, keys };
}

function watchTools({ model, view, editor, keys }) {
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
  // Two clicks on a box or a body are no wish to zoom.
  stage.addEventListener("dblclick", (event) => {
    if (story.bounds && hit(...pixelsOf(event, stage), 10, model.selection)) event.stopImmediatePropagation();
  }, { capture: true });
}

function openExample({ model }, name) {
  model.open(examples.find((example) => example.name === name).problem, name);
}

/** The problem that the address holds or names, or the first example. */
async function openWished(parts) {
  try {
    const { problem, example } = await wishesOf(location);
    if (problem) {
      await parts.engine.ask("check", { problem });
      return parts.model.open(problem, "shared");
    }
    if (examples.some(({ name }) => name === example)) return openExample(parts, example);
  } catch (error) {
    notice(`The link holds no problem: ${error.message}`, true);
  }
  return openExample(parts, firstExample);
}

function fillExamples(parts) {
  for (const { group, name } of examples) {
    let place = [...by("example").children].find((child) => child.label === group);
    if (!place) {
      place = document.createElement("optgroup");
      place.label = group;
      by("example").append(place);
    }
    place.append(new Option(name, name));
  }
  by("example").addEventListener("change", () => openExample(parts, by("example").value));
  parts.model.onChange(({ name }) => { by("example").value = examples.some((example) => example.name === name) ? name : ""; });
}

async function start() {
  const parts = makeParts();
  makePlots();
  watchStage();
  watchTools(parts);
  new Inspector(parts.model);
  fillExamples(parts);
  watchPlayback({ show: () => parts.view.paint(), announce: (step, last) => announce(`Step ${step} of ${last}`) });
  const wishes = await wishesOf(location).catch(() => ({}));
  const planning = wishes.lesson ? startLesson(parts, wishes) : startPlayground(parts);
  await openWished(parts);
  parts.view.watch();
  // For tests, and for the curious: the parts that the page is made of.
  window.playground = { ...parts, planning };
  window.addEventListener("hashchange", () => openWished(parts));
}

start().catch((error) => notice(`The playground does not start: ${error.message}`, true));
