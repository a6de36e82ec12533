// Problem, scenario and solution files, in and out, by the engine's readers and writers.

const by = (id) => document.getElementById(id);

function save({ name, text }) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const placeOf = ({ line, column }) => (line ? `, line ${line}${column ? `, column ${column}` : ""}` : "");

/** A chosen file as text, and its bytes as characters, as the engine takes those of maps. */
async function withContent(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const characters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return { name: file.name, text: new TextDecoder().decode(bytes), characters };
}

const isScenario = ({ text }) => text.trimStart().startsWith("{");

export class Files {
  /** path(): the states on show or null; showPath(states): a solution was opened, throws where it is not valid; say(text): a notice. */
  constructor(engine, model, { path, showPath, say }) {
    Object.assign(this, { engine, model, path, showPath, say });
    by("open").addEventListener("click", () => by("file").click());
    by("file").addEventListener("change", () => this.openAll([...by("file").files]));
    for (const what of ["problem", "scenario", "solution"]) by(`save-${what}`).addEventListener("click", () => this.write(what));
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      this.openAll([...event.dataTransfer.files]);
    });
  }

  /** Opens files one after the other, scenarios first: what they name as maps are no files to open. */
  async openAll(chosen) {
    by("file").value = "";
    const files = await Promise.all(chosen.map(withContent));
    const together = Object.fromEntries(files.map(({ name, characters }) => [name, characters]));
    const maps = new Set();
    for (const { name, text } of files.sort((a, b) => isScenario(b) - isScenario(a))) {
      if (!maps.has(name)) (await this.openText(name, text, together)).forEach((map) => maps.add(map));
    }
  }

  /**
   * Opens the text of a file: a problem, a scenario with the files that it may name as maps, or a solution of the problem on
   * show. Returns the names of the maps.
   */
  async openText(name, text, files = {}) {
    try {
      const { problem, states, maps = [] } = await this.engine.ask("read", { name, text, files, problem: this.model.problem });
      if (states) await this.showPath(states);
      else this.model.open(problem, name.replace(/\.[^.]*$/, ""));
      this.say(states ? `The path of ${name} is valid, and shown.` : `${[name, ...maps].join(" with ")} is opened.`);
      return maps;
    } catch (error) {
      this.say(`${name}${placeOf(error)}: ${error.message}`, true);
      return [];
    }
  }

  async write(what) {
    const states = this.path();
    if (what === "solution" && !states) return this.say("There is no path to save yet.", true);
    try {
      const file = await this.engine.ask("write", { what, problem: this.model.problem, states: states ? states.slice() : null });
      const ending = { problem: ".txt", scenario: ".json", solution: ".solution.txt" }[what];
      save({ name: this.model.name + ending, text: file.text });
      this.say(`${this.model.name}${ending} is saved.`);
    } catch (error) {
      this.say(error.message, true);
    }
  }
}
