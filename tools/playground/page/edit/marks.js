// What is not valid about a start or a goal, asked of the engine, for the field and for the page.

import { bodyPoints } from "../model/kinematics.js";

export class Marks {
  /** onChange(lines): the sentences of what fails have changed. */
  constructor(engine, onChange) {
    Object.assign(this, { engine, onChange, marks: [], asking: false, next: undefined });
  }

  /** Looks at the ends of a problem (both, or the named one); null clears the marks. Latest wins. */
  async look(problem, ends = ["start", "goal"]) {
    this.next = { problem, ends };
    if (this.asking) return;
    this.asking = true;
    while (this.next) {
      const { problem: asked, ends: which } = this.next;
      this.next = undefined;
      const marks = asked ? await this.marksOf(asked, which) : [];
      if (this.next) continue;
      this.marks = marks;
      this.onChange(marks.map(({ end, violation }) => `${end}: ${violation.requirement}: ${violation.text}`));
    }
    this.asking = false;
  }

  async marksOf(problem, ends) {
    try {
      const answer = await this.engine.ask("check", { problem });
      return ends.flatMap((end) => (answer[end] ?? []).map((violation) => ({ end, violation, points: bodyPoints(problem, problem[end]) })));
    } catch {
      return []; // a plan of the same problem says what is wrong with it
    }
  }
}
