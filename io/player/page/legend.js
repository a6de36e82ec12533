// The legend: the entries of the page that apply to what is shown, in the words of the body.

function writeLegend() {
  const solved = story.states > 0;
  const has = (kind) => story.trees.some((tree) => tree.kind === kind);
  const entries = {
    "first": story.words.first !== "",
    "closing": story.body === "chain" && story.asvCount > 2,
    "now": solved,
    "path": solved,
    "share": solved,
    "clearance": solved && story.obstacles.length > 0,
    "start-tree": has("start"),
    "goal-tree": has("goal"),
    "roadmap": has("roadmap"),
    "violation": !story.valid,
  };
  for (const [name, applies] of Object.entries(entries)) document.getElementById(`legend-${name}`).hidden = !applies;
  for (const place of document.querySelectorAll("#legend [data-word]")) {
    place.textContent = story.words[place.dataset.word];
  }
}
