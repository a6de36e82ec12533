// Drags in the field: what is taken hold of follows the pointer, once for each frame.

import { stage } from "player";
import { bodyPoints, centreOf, headingsOf } from "../model/kinematics.js";
import { addBox, movedBox, moveEnd, pullEnd, putBox, removeBox, turnEnd } from "../model/edits.js";
import { hit, pixelsOf, planeOf } from "./handles.js";

const mouseReach = 10;
const fingerReach = 22;
const leastSide = 4; // pixels: a smaller new box is a slip of the hand

export class Editor {
  /** onHeld(end, wished problem, or null): the end could not go all the way to where it was dragged. */
  constructor(model, onHeld) {
    Object.assign(this, { model, onHeld, grid: 0, drawing: false, drag: null, asked: false });
    stage.addEventListener("pointerdown", (event) => this.down(event), { capture: true });
    stage.addEventListener("pointermove", (event) => this.move(event), { capture: true });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
      stage.addEventListener(end, (event) => this.up(event), { capture: true });
    }
  }

  snap(value) {
    return this.grid ? Math.round(value / this.grid) * this.grid : value;
  }

  setDrawing(drawing) {
    this.drawing = drawing;
    stage.classList.toggle("drawing", drawing);
    document.getElementById("draw").setAttribute("aria-pressed", String(drawing));
  }

  down(event) {
    if (event.target.closest("button") || event.button !== 0) return;
    if (this.drag) return this.cancelFor(event);
    const place = pixelsOf(event, stage);
    const reach = event.pointerType === "touch" ? fingerReach : mouseReach;
    const found = this.drawing || event.shiftKey ? null : hit(...place, reach, this.model.selection);
    if (found) this.begin(event, found, place);
    else if (this.drawing || event.shiftKey) this.begin(event, { kind: "box", part: "new" }, place);
    else if (this.model.selection) this.model.select(null);
  }

  /** A second finger zooms: what the first one had begun ends. */
  cancelFor(event) {
    if (event.pointerId !== this.drag.pointer) event.stopImmediatePropagation();
  }

  begin(event, found, place) {
    event.stopImmediatePropagation();
    stage.focus({ preventScroll: true });
    stage.setPointerCapture(event.pointerId);
    stage.classList.add("editing");
    const { problem } = this.model;
    const at = planeOf(place);
    this.drag = { ...found, pointer: event.pointerId, at, place, from: place };
    if (found.kind === "box" && found.part !== "new") this.drag.box = problem.obstacles[found.index];
    if (found.kind !== "box") {
      const points = bodyPoints(problem, problem[found.kind]);
      this.drag.centre = found.part === "move" && problem.body.kind === "arm" ? points.slice(0, 2) : centreOf(points);
      if (found.part === "point") this.drag.offset = [points[2 * found.index] - at[0], points[2 * found.index + 1] - at[1]];
      this.drag.heading = headingsOf(points)[0];
      this.drag.angle = Math.atan2(at[1] - this.drag.centre[1], at[0] - this.drag.centre[0]);
    }
    if (found.part !== "new") this.model.select({ kind: found.kind, index: found.kind === "box" ? found.index : undefined });
    this.model.hold();
  }

  move(event) {
    if (this.drag?.pointer !== event.pointerId) {
      if (!this.drag && event.pointerType === "mouse") this.hover(event);
      return;
    }
    event.stopImmediatePropagation();
    this.drag.place = pixelsOf(event, stage);
    this.drag.moved = true;
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.drag) this.follow();
    });
  }

  hover(event) {
    const found = this.drawing ? null : hit(...pixelsOf(event, stage), mouseReach, this.model.selection);
    stage.style.cursor = this.drawing ? "crosshair" : !found ? "" : found.part === "move" ? "move" : "pointer";
  }

  up(event) {
    if (this.drag?.pointer !== event.pointerId) return;
    event.stopImmediatePropagation();
    if (this.drag.moved) this.follow();
    const { part, index } = this.drag;
    this.drag = null;
    stage.classList.remove("editing");
    if (part === "new") this.endDrawing(index);
    this.onHeld(null);
    this.model.release();
  }

  endDrawing(index) {
    this.setDrawing(false);
    if (index === undefined) return;
    const [low, high] = this.model.problem.obstacles[index];
    const [left, right] = [planeOf([0, 0])[0], planeOf([leastSide, 0])[0]];
    if (Math.min(high[0] - low[0], high[1] - low[1]) < right - left) {
      this.model.edit(removeBox(index));
      this.model.select(null);
    }
  }

  follow() {
    const { drag } = this;
    const [x, y] = planeOf(drag.place);
    if (drag.kind === "box") this.followBox(drag, x, y);
    else this.followEnd(drag, x, y);
  }

  followBox(drag, x, y) {
    if (drag.part === "new") {
      const box = [[this.snap(drag.at[0]), this.snap(drag.at[1])], [this.snap(x), this.snap(y)]];
      if (drag.index === undefined) {
        drag.index = this.model.boxes.length;
        this.model.edit(addBox(box));
        this.model.select({ kind: "box", index: drag.index });
      } else {
        this.model.edit(putBox(drag.index, box));
      }
      return;
    }
    const [low, high] = drag.box;
    const [dx, dy] = [x - drag.at[0], y - drag.at[1]];
    if (drag.part === "move") {
      const target = [this.snap(low[0] + dx), this.snap(low[1] + dy)];
      this.model.edit(putBox(drag.index, movedBox(drag.box, target[0] - low[0], target[1] - low[1])));
      return;
    }
    const [shareX, shareY] = drag.share;
    const side = (share, lowest, highest, delta) => [
      share === 0 ? this.snap(lowest + delta) : lowest, share === 1 ? this.snap(highest + delta) : highest];
    const [left, right] = side(shareX, low[0], high[0], dx);
    const [bottom, top] = side(shareY, low[1], high[1], dy);
    this.model.edit(putBox(drag.index, [[left, bottom], [right, top]]));
  }

  followEnd(drag, x, y) {
    const { problem } = this.model;
    const points = bodyPoints(problem, problem[drag.kind]);
    const change = (snap) => this.endChange(drag, points, x, y, snap);
    const wished = change(false)(problem);
    this.model.edit(change(true));
    const held = JSON.stringify(wished[drag.kind]) !== JSON.stringify(this.model.problem[drag.kind]);
    this.onHeld(drag.kind, held ? wished : null);
  }

  endChange(drag, points, x, y, snap) {
    if (drag.part === "point") return pullEnd(drag.kind, drag.index, this.snap(x + drag.offset[0]), this.snap(y + drag.offset[1]), snap);
    const [centreX, centreY] = this.model.problem.body.kind === "arm" && drag.part === "move" ? points : centreOf(points);
    if (drag.part === "turn") {
      const by = Math.atan2(y - centreY, x - centreX) - drag.angle - (headingsOf(points)[0] - drag.heading);
      return turnEnd(drag.kind, Math.atan2(Math.sin(by), Math.cos(by)), snap);
    }
    const target = [this.snap(drag.centre[0] + x - drag.at[0]), this.snap(drag.centre[1] + y - drag.at[1])];
    return moveEnd(drag.kind, target[0] - centreX, target[1] - centreY, snap);
  }
}
