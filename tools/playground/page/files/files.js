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

  async openAll(files) {
    by("file").value = "";
    for (const file of files) await this.openText(file.name, await file.text());
  }

  /** Opens the text of a file: a problem, a scenario, or a solution of the problem on show. */
  async openText(name, text) {
    try {
      const { problem, states } = await this.engine.ask("read", { name, text, problem: this.model.problem });
      if (states) await this.showPath(states);
      else this.model.open(problem, name.replace(/\.[^.]*$/, ""));
      this.say(states ? `The path of ${name} is valid, and shown.` : `${name} is opened.`);
    } catch (error) {
      this.say(`${name}${placeOf(error)}: ${error.message}`, true);
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
