// What can be taken hold of in the field, where it is, and how it is drawn.

import { camera, colours, fieldSide, nearestOnSegment, obstacleBox, paintChain, scaleOf, story, toPageX, toPageY } from "player";
import { centreOf } from "../model/kinematics.js";

const turnReach = 58; // pixels from the middle of a body to the handle that turns it
const corners = [[0, 0], [0.5, 0], [1, 0], [1, 0.5], [1, 1], [0.5, 1], [0, 1], [0, 0.5]];

export const ends = ["goal", "start"];

/** Where the handle that turns a body is, in the plane: above its middle, or below near the upper edge. */
export function turnHandle(points) {
  const [x, y] = centreOf(points);
  const above = toPageY(y) > turnReach + 14;
  return [x, y + ((above ? 1 : -1) * turnReach) / scaleOf()];
}

/** The eight places at which a box is resized, each with the share of width and height where it is. */
export const boxHandles = ([lowX, lowY, highX, highY]) =>
  corners.map((share) => ({ share, x: lowX + share[0] * (highX - lowX), y: lowY + share[1] * (highY - lowY) }));

/** What is under a place of the stage (pixels), within `reach` pixels; null for nothing. */
export function hit(pageX, pageY, reach, selection) {
  const near = (x, y, radius = reach) => Math.hypot(toPageX(x) - pageX, toPageY(y) - pageY) <= radius;
  if (selection && selection.kind !== "box" && story.body !== "point" && near(...turnHandle(story[selection.kind]))) {
    return { kind: selection.kind, part: "turn" };
  }
  if (selection?.kind === "box") {
    const handle = boxHandles(obstacleBox(selection.index)).find(({ x, y }) => near(x, y));
    if (handle) return { ...selection, part: "resize", share: handle.share };
  }
  return hitBody(near, pageX, pageY, reach, selection) ?? hitBox(pageX, pageY, reach);
}

function hitBody(near, pageX, pageY, reach, selection) {
  const order = selection?.kind === "goal" ? ends : [...ends].reverse();
  for (const kind of order) {
    const points = story[kind];
    let best = null;
    for (let i = 0; i < points.length; i += 2) {
      const gap = Math.hypot(toPageX(points[i]) - pageX, toPageY(points[i + 1]) - pageY);
      if (gap <= reach * 0.7 && (!best || gap < best.gap)) best = { gap, index: i / 2 };
    }
    if (best) return { kind, part: points.length === 2 ? "move" : "point", index: best.index };
    for (let i = 0; i + 3 < points.length; i += 2) {
      const [ax, ay, bx, by] = [toPageX(points[i]), toPageY(points[i + 1]), toPageX(points[i + 2]), toPageY(points[i + 3])];
      const [x, y] = nearestOnSegment(pageX, pageY, ax, ay, bx, by);
      if (Math.hypot(x - pageX, y - pageY) <= reach) return { kind, part: "move" };
    }
    if (story.body !== "arm" && near(...centreOf(points), reach)) return { kind, part: "move" };
  }
  return null;
}

function hitBox(pageX, pageY, reach) {
  for (const slack of [0, reach / 2]) {
    for (let i = story.obstacles.length / 4 - 1; i >= 0; --i) {
      const [lowX, lowY, highX, highY] = obstacleBox(i);
      if (pageX >= toPageX(lowX) - slack && pageX <= toPageX(highX) + slack &&
          pageY >= toPageY(highY) - slack && pageY <= toPageY(lowY) + slack) return { kind: "box", index: i, part: "move" };
    }
  }
  return null;
}

function dot(context, x, y, radius, fill, ring) {
  context.beginPath();
  context.arc(toPageX(x), toPageY(y), radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.strokeStyle = ring;
  context.lineWidth = 2;
  context.fill();
  context.stroke();
}

function paintTurnHandle(context, points, colour) {
  const [x, y] = turnHandle(points);
  const [centreX, centreY] = centreOf(points);
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(toPageX(centreX), toPageY(centreY));
  context.lineTo(toPageX(x), toPageY(y));
  context.stroke();
  dot(context, x, y, 9, colours.field, colour);
  context.beginPath();
  context.arc(toPageX(x), toPageY(y), 4.5, -2.4, 1.6);
  context.stroke();
}

/** The handles of what is selected. */
export function paintHandles(context, selection) {
  if (!selection) return;
  if (selection.kind === "box") {
    const box = obstacleBox(selection.index);
    const [lowX, lowY, highX, highY] = box;
    context.strokeStyle = colours.ink;
    context.lineWidth = 2;
    context.strokeRect(toPageX(lowX), toPageY(highY), (highX - lowX) * scaleOf(), (highY - lowY) * scaleOf());
    for (const { x, y } of boxHandles(box)) dot(context, x, y, 5, colours.field, colours.ink);
    return;
  }
  const points = story[selection.kind];
  const colour = colours[selection.kind];
  for (let i = 0; i < points.length; i += 2) dot(context, points[i], points[i + 1], 6, colours.field, colour);
  if (story.body !== "point") paintTurnHandle(context, points, colour);
}

/** What was asked for but is not valid: dashed and red, with a cross where it fails. */
export function paintMark(context, { points, violation }) {
  context.save();
  context.setLineDash([5, 4]);
  context.globalAlpha = 0.8;
  paintChain(context, points, colours.violation, 2, 3);
  context.restore();
  const count = points.length / 2;
  context.strokeStyle = colours.violation;
  if (violation.obstacle && 4 * violation.obstacle <= story.obstacles.length) {
    const [lowX, lowY, highX, highY] = obstacleBox(violation.obstacle - 1);
    context.lineWidth = 3;
    context.strokeRect(toPageX(lowX), toPageY(highY), (highX - lowX) * scaleOf(), (highY - lowY) * scaleOf());
  }
  let [x, y] = centreOf(points);
  if (violation.broom) {
    const [a, b] = [violation.broom - 1, Math.min(violation.broom, count - 1)];
    [x, y] = [(points[2 * a] + points[2 * b]) / 2, (points[2 * a + 1] + points[2 * b + 1]) / 2];
  } else if (violation.asv) {
    [x, y] = points.slice(2 * violation.asv - 2, 2 * violation.asv);
  }
  const [px, py] = [toPageX(x), toPageY(y)];
  context.lineWidth = 2.5;
  context.beginPath();
  context.arc(px, py, 11, 0, 2 * Math.PI);
  for (const side of [-1, 1]) {
    context.moveTo(px - 5, py - 5 * side);
    context.lineTo(px + 5, py + 5 * side);
  }
  context.stroke();
}

/** Sizes for keys and snapping: a share of the field. */
export const keyStep = (grid) => grid || fieldSide() / 100;

/** Where an event is in the stage, in pixels. */
export const pixelsOf = (event, stage) => {
  const box = stage.getBoundingClientRect();
  return [event.clientX - box.left - stage.clientLeft, event.clientY - box.top - stage.clientTop];
};

/** The place of the plane that is drawn at a pixel of the stage. */
export const planeOf = ([pageX, pageY]) => [
  camera.x + (pageX - camera.size / 2) / scaleOf(),
  camera.y - (pageY - camera.size / 2) / scaleOf(),
];
