// The live loop: each change of the problem is answered by a path as soon as there is one; when
// nothing changes any more, the path gets shorter. What is shown is always one problem with its
// own path, or with none: a problem waits a moment for its path, and is then shown without it.

/** Seconds for the first look at a problem that has a path to start from, and for the looks after it when it stays unsolved. */
const firstLook = 0.2;
const longestLook = 1;
/** Seconds without a path after which "unknown" is the answer. */
const patience = 20;
/** Seconds of one slice of improvement, and slices in a row without a gain that end it. */
const slice = 0.03;
const vainSlices = 8;
const leastGain = 1e-5;
/**
 * Milliseconds without a change after which a path is improved, since a slice of that would keep the next change waiting;
 * more while something is held that may go on.
 */
const [rest, restWhileHeld] = [150, 1000];
/** Milliseconds that a changed problem waits for its path before it is shown without one. */
const wait = 120;
/** Milliseconds after which a plan for an old problem is not waited for any more. */
const tooOld = 1500;

export class Planning {
  /**
   * present(shown, done, samePath): shown is {problem, version, state, answer}; state says what the answer is worth, done
   * that no better one is looked for, samePath that the path is the one that was presented last.
   */
  constructor(engine, model, present) {
    Object.assign(this, { engine, model, present });
    this.planner = "auto";
    this.settings = {};
    this.shown = { version: -1 };
    this.best = null; // the last path, of whatever problem: where the next plan starts
    this.busy = false;
    this.sent = 0;
    this.timings = []; // milliseconds from a change to the path that answers it, painted
    this.wakeUp = () => {};
    /** What the first path has no need of is to wait for this. */
    this.firstAnswer = new Promise((resolve) => { this.answered = resolve; });
    model.onChange(() => this.changed());
  }

  changed() {
    this.wakeUp();
    if (this.version === this.model.version) return;
    this.version = this.model.version;
    this.changedAt = performance.now();
    this.look = this.best ? firstLook : longestLook;
    this.spent = 0;
    this.vain = 0;
    this.seed = 1;
    this.done = false;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.showWithout("planning"), wait);
    this.giveUpTooOld();
    this.pump();
  }

  /** What takes long for a problem that is no more must not keep the new one waiting. */
  giveUpTooOld() {
    if (!this.busy || performance.now() - this.sent < tooOld) return;
    this.sent = performance.now(); // the new worker gets its time to start
    this.engine.restart();
  }

  showWithout(state, answer = null, problem = this.model.problem, version = this.version) {
    if (version < this.shown.version) return;
    if (version === this.shown.version && this.shown.state === "solved") return;
    this.show({ problem, version, state, answer });
  }

  show(shown) {
    this.shown = shown;
    if (shown.state === "solved") this.firstPathAt ??= performance.now();
    this.present(shown, false, false);
  }

  /** Another planner, or the same with other settings ({key: value}): from nothing. */
  restart(planner, settings = {}) {
    Object.assign(this, { planner, settings });
    this.best = null;
    this.version = -1;
    this.shown = { version: -1 };
    this.changed();
  }

  /** A path from a file: shown if it is valid for the problem, and improved from there. Throws where it is not. */
  async offer(states) {
    const { problem, version } = this.model;
    const { valid, checks, cost } = await this.engine.ask("validate", { problem, states: states.slice() });
    if (!valid) throw new Error(checks.filter(({ ok }) => !ok).map(({ name, text }) => `${name}: ${text}`).join("; "));
    if (version !== this.version) return;
    const bound = this.shown.answer?.bound ?? null;
    this.best = { states, columns: columnsOf(problem) };
    [this.vain, this.done] = [0, false];
    this.show({ problem, version, state: "solved", answer: { cost, bound, states, seconds: null } });
    this.pump();
  }

  /** Asks for one plan after the other until there is nothing more to gain. */
  async pump() {
    if (this.busy) return;
    this.busy = true;
    try {
      while (!this.done) {
        await this.engine.whenReady();
        await this.planOnce();
        if (this.solved) await this.stillness();
      }
    } catch (error) {
      this.done = true;
      this.showWithout("error", { reason: error.message });
    }
    this.busy = false;
  }

  /** Is the path on show one for the problem as it is now? */
  get solved() {
    return this.shown.version === this.version && this.shown.state === "solved";
  }

  /** Resolves when the problem changes, or has not changed for a while. */
  async stillness() {
    const left = () => this.changedAt + (this.model.held ? restWhileHeld : rest) - performance.now();
    do {
      // Also where there is nothing left to wait for: what the page has to do goes first.
      await new Promise((resolve) => {
        this.wakeUp = resolve;
        setTimeout(resolve, left());
      });
    } while (this.solved && left() > 0);
  }

  async planOnce() {
    const { problem, version } = this.model;
    const askedAt = this.changedAt;
    const before = this.solved ? this.shown.answer : null;
    const improving = before !== null;
    this.sent = performance.now();
    const answer = await this.engine.ask("plan", {
      problem, planner: this.planner, settings: this.settings, seed: this.seed, slot: "live", trees: false,
      optimize: improving ? slice : 0, timeLimit: improving ? 2 : this.look, bound: improving && !before.bound, progress: false,
      warm: this.best && this.best.columns === columnsOf(problem) ? this.best.states.slice() : null,
    });
    this.answered();
    if (before) answer.bound = before.bound ??= answer.bound; // of one problem it is found once
    if (answer.status === "solved" && answer.valid) this.take(answer, problem, version, before);
    else if (answer.status === "not found" && this.spent === 0) this.without(await this.proofOr(answer, problem), problem, version);
    else this.without(answer, problem, version);
    if (answer.status !== "interrupted" && !improving) this.timings.push(performance.now() - askedAt);
  }

  /** A short look may end before the proof that there is no path; that is asked for on its own. */
  async proofOr(answer, problem) {
    const { infeasible } = await this.engine.ask("check", { problem });
    return infeasible ? { ...answer, status: "infeasible", reason: infeasible } : answer;
  }

  /** A valid path for a problem; `before` is the answer that it was to improve on, or null. */
  take(answer, problem, version, before) {
    const latest = version === this.version;
    const gained = !before || answer.cost < before.cost * (1 - leastGain);
    if (latest) {
      clearTimeout(this.timer);
      this.vain = gained ? 0 : this.vain + 1;
      this.seed += 1;
      const atBound = answer.bound && answer.cost <= answer.bound * (1 + leastGain);
      this.done = this.vain >= vainSlices || Boolean(atBound);
    }
    if (version >= this.shown.version && gained) {
      this.best = { states: answer.states, columns: columnsOf(problem) };
      this.show({ problem, version, state: "solved", answer });
    }
    // The path is on show already, but its bound or that it is the last one may be news.
    if (latest && (this.done || !gained)) this.present(this.shown, this.done, true);
  }

  /** No path, whatever the reason. */
  without(answer, problem, version) {
    if (version !== this.version || answer.status === "interrupted") return;
    if (answer.status === "infeasible" || answer.status === "invalid ends") {
      this.done = true;
      clearTimeout(this.timer);
      this.showWithout(answer.status, answer, problem, version);
      return;
    }
    if (this.shown.version === version && this.shown.state === "solved") {
      // A slice of improvement that brought nothing, not even the path it began with.
      this.done = ++this.vain >= vainSlices;
      return;
    }
    this.spent += this.look;
    this.look = Math.min(2 * this.look, longestLook);
    this.seed += 1;
    this.done = this.spent >= patience;
    this.showWithout(this.done ? "unknown" : "planning", answer, problem, version);
  }
}

/** Numbers in one state of a path. */
export function columnsOf(problem) {
  if (problem.body.kind === "point") return 2;
  return 2 * (problem.start.length + (problem.body.kind === "arm" ? 1 : 0));
}
