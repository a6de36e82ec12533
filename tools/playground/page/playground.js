// The live page: a path that follows the problem, files and links, planners side by side.

import { Files } from "./files/files.js";
import { toHash } from "./files/share.js";
import { Planning } from "./plan/planning.js";
import { PlannerSettings } from "./plan/settings.js";
import { Compare } from "./show/compare.js";
import { announce, notice } from "./show/notice.js";
import { writeVerdict } from "./show/verdict.js";
import { captionOf, paintWhy, whyOf } from "./show/why.js";

const by = (id) => document.getElementById(id);

/** Shows what planning has: one problem with its own path, or with none. */
function presenter({ engine, view, editor, marks }) {
  let [why, told] = [null, ""];
  view.extra.unshift((context) => paintWhy(context, why));

  /** Asks for the measures of the path on show, unless another one has come since. */
  async function measure(planning, shown) {
    const measures = await engine.ask("profile", { problem: shown.problem, states: shown.answer.states.slice() });
    if (planning.shown === shown && measures.cost) view.measure(measures);
  }

  const present = (planning, shown, done, samePath) => {
    view.hurried = Boolean(editor.drag);
    const solved = shown.state === "solved";
    why = shown.state === "infeasible" ? whyOf(shown.problem) : null;
    const headline = writeVerdict(shown, done, captionOf(why));
    // A path that gets shorter is no news to those who hear the page.
    if (shown.state !== "planning" && headline !== told) announce(headline);
    told = headline;
    if (samePath) return;
    view.tell(shown.problem, solved ? shown.answer.states : null);
    if (shown.state === "invalid ends") marks.look(shown.problem);
    else if (!editor.drag) marks.look(null);
    if (solved && !editor.drag) measure(planning, shown);
  };
  /** The end of a drag: what was left out in the hurry is shown. */
  const settle = (planning) => {
    if (editor.drag || !view.hurried) return;
    view.hurried = false;
    view.paint({ ground: true });
    if (planning.shown.state === "solved") measure(planning, planning.shown);
  };
  return { present, settle };
}

async function share(model) {
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

async function fillPlanners(engine, planning) {
  const { planners } = await engine.ask("planners");
  for (const { name, summary } of planners) by("planner").append(Object.assign(new Option(name, name), { title: summary }));
  by("planner").value = planning.planner;
  const settings = new PlannerSettings(planners, (values) => planning.restart(planning.planner, { ...values }));
  settings.show(planning.planner);
  by("planner").addEventListener("change", () => {
    settings.show(by("planner").value);
    planning.restart(by("planner").value);
  });
  return planners;
}

/** Returns the live loop. */
export function startPlayground(parts) {
  const { engine, model } = parts;
  const { present, settle } = presenter(parts);
  const planning = new Planning(engine, model, (...news) => present(planning, ...news));
  planning.firstAnswer.then(() => fillPlanners(engine, planning)).then((planners) => new Compare(model, planners));
  model.onChange(() => settle(planning));
  by("share").addEventListener("click", () => share(model));
  new Files(engine, model, {
    path: () => (planning.shown.state === "solved" ? planning.shown.answer.states : null),
    showPath: (states) => planning.offer(states),
    say: notice,
  });
  return planning;
}
