// Says what the path on show is worth: proven valid, not there yet, impossible and why, or unknown.

const by = (id) => document.getElementById(id);

function put(id, text) {
  if (by(id).textContent !== text) by(id).textContent = text;
}

const words = {
  planning: ["No path yet", "Looking for one."],
  unknown: ["Unknown", "The time ran out without a path. Nothing is proven: there may be one."],
  error: ["The engine stopped", ""],
};

/** The headline and the sentence below it for what planning shows. */
export function verdictOf({ state, answer }, done) {
  if (state === "solved") {
    const { cost, bound } = answer;
    const ratio = bound > 0 ? `, at most ${(cost / bound).toFixed(3)} times the least possible` : "";
    return { headline: "\u2713 Valid path", tone: "good",
      sentence: `Every step and every motion of it is checked${ratio}. ${done ? "No shorter one was found." : "Getting shorter \u2026"}` };
  }
  if (state === "infeasible") {
    return { headline: "\u2717 There is no path", tone: "bad", sentence: `Proven: ${answer.reason}.` };
  }
  if (state === "invalid ends") return { headline: "\u2717 Not a valid problem", tone: "bad", sentence: `${answer.reason}` };
  const [headline, sentence] = words[state] ?? words.planning;
  return { headline, tone: state === "planning" ? "" : "bad", sentence: sentence || answer?.reason || "" };
}

/** Writes it, with a caption of what is drawn; the read-outs of cost and bound are empty where there is no path. */
export function writeVerdict(shown, done, caption) {
  const { headline, tone, sentence } = verdictOf(shown, done);
  put("verdict", headline);
  by("verdict").className = tone;
  put("reason", [sentence, caption].filter(Boolean).join(" "));
  document.body.dataset.path = shown.state === "solved" ? "valid" : "none";
  document.body.dataset.state = shown.state;
  const solved = shown.state === "solved" ? shown.answer : null;
  put("total-cost", solved ? solved.cost.toFixed(4) : "\u2013");
  put("bound", solved?.bound ? solved.bound.toFixed(4) : "\u2013");
  put("ratio", solved?.bound ? (solved.cost / solved.bound).toFixed(4) : "\u2013");
  put("first-time", solved?.seconds ? `${(1000 * solved.seconds.total).toFixed(1)} ms` : "\u2013");
  return headline;
}

/** Where start and goal fail: one line for each violation. */
export function writeViolations(lines) {
  by("violations").replaceChildren(...lines.map((line) => {
    const item = document.createElement("li");
    item.textContent = line;
    return item;
  }));
  by("violations").hidden = lines.length === 0;
}
