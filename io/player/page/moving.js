// Paints what changes from frame to frame: the trails of the ASVs, and the chain.

/**
 * The states that are enough to draw the way of each ASV at the present zoom: those that lie more
 * than a pixel from the last one kept. Found anew when the zoom has changed much.
 */
const sparse = { scale: 0, kept: [] };

function thinWays() {
  const scale = scaleOf();
  if (scale < 1.5 * sparse.scale && scale > sparse.scale / 1.5) return;
  sparse.scale = scale;
  const gap = 1 / scale ** 2;
  const columns = 2 * story.asvCount;
  sparse.kept = Array.from({ length: story.asvCount }, (_, asv) => {
    const kept = [0];
    let [x, y] = chainAt(0).subarray(2 * asv);
    for (let state = 1; state < story.states; ++state) {
      const at = state * columns + 2 * asv;
      const [u, v] = [story.positions[at], story.positions[at + 1]];
      if ((u - x) ** 2 + (v - y) ** 2 < gap) continue;
      [x, y] = [u, v];
      kept.push(state);
    }
    return Int32Array.from(kept);
  });
}

/** The ways of all ASVs from one state to another, coloured from start to goal in pieces. */
function strokeWay(context, first, last) {
  if (last <= first) return;
  thinWays();
  const columns = 2 * story.asvCount;
  const pieces = Math.ceil((shareOf(last) - shareOf(first)) * 24) || 1;
  let begin = first;
  for (let piece = 1; piece <= pieces && begin < last; ++piece) {
    const share = shareOf(first) + ((shareOf(last) - shareOf(first)) * piece) / pieces;
    const end = piece === pieces ? last : clamp(firstAbove(story.cost, share * story.cost[story.states - 1]), begin + 1, last);
    context.strokeStyle = colourAlong(share);
    context.beginPath();
    for (let asv = 0; asv < story.asvCount; ++asv) {
      const visit = (state, go) => {
        const at = state * columns + 2 * asv;
        context[go](toPageX(story.positions[at]), toPageY(story.positions[at + 1]));
      };
      const kept = sparse.kept[asv];
      visit(begin, "moveTo");
      for (let k = firstAbove(kept, begin); k < kept.length && kept[k] < end; ++k) visit(kept[k], "lineTo");
      visit(end, "lineTo");
    }
    context.stroke();
    begin = end;
  }
}

/**
 * The trail layer shows the ways up to state `end`. It grows cheaply; to go back, it is restored
 * from the last of a few pictures that were kept at even stretches of the way.
 */
const trail = { end: 0, kept: [] };

const trailPictures = 24;

/** The states at which a picture of the trail is kept. */
const pictureState = (k) => firstAbove(story.cost, (k / trailPictures) * story.cost[story.states - 1]);

function keepTrailPicture(k) {
  const source = layers.trail.canvas;
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [source.width, source.height];
  copy.getContext("2d").drawImage(source, 0, 0);
  trail.kept[k] = { state: trail.end, copy };
}

function restoreTrail(state) {
  const context = layers.trail;
  const picture = trail.kept.findLast((kept) => kept && kept.state <= state);
  prepareLayer(context);
  trail.end = picture ? picture.state : 0;
  if (picture) context.drawImage(picture.copy, 0, 0, camera.size, camera.size);
}

function paintTrail(state, anew) {
  const context = layers.trail;
  if (anew) trail.kept = [];
  if (anew || state < trail.end) restoreTrail(state);
  if (!shown.trails) return;
  context.lineWidth = 1.6;
  for (let k = trail.kept.length || 1; k < trailPictures && pictureState(k) <= state; ++k) {
    strokeWay(context, trail.end, pictureState(k));
    trail.end = pictureState(k);
    keepTrailPicture(k);
  }
  strokeWay(context, trail.end, state);
  trail.end = state;
}

/** Red, with a cross: where a requirement is violated. */
function paintViolation(context, state, violation) {
  const points = chainAt(state);
  const asv = Math.max(violation.asv, 0);
  let [x, y] = [points[2 * asv], points[2 * asv + 1]];
  context.strokeStyle = context.fillStyle = colours.violation;
  if (violation.broom >= 0) {
    const broom = broomAt(state, violation.broom);
    context.lineWidth = 6;
    traceLine(context, broom);
    context.stroke();
    [x, y] = [(broom[0] + broom[2]) / 2, (broom[1] + broom[3]) / 2];
    if (violation.obstacle >= 0) [x, y] = shortestLink(broom, obstacleBox(violation.obstacle));
  }
  if (violation.obstacle >= 0) {
    const [lowX, lowY, highX, highY] = obstacleBox(violation.obstacle);
    context.lineWidth = 3;
    context.strokeRect(toPageX(lowX), toPageY(highY), (highX - lowX) * scaleOf(), (highY - lowY) * scaleOf());
  }
  const [px, py] = [toPageX(x), toPageY(y)];
  context.lineWidth = 2.5;
  context.beginPath();
  context.arc(px, py, 12, 0, 2 * Math.PI);
  context.moveTo(px - 5, py - 5);
  context.lineTo(px + 5, py + 5);
  context.moveTo(px - 5, py + 5);
  context.lineTo(px + 5, py - 5);
  context.stroke();
}

function paintClearance(context, state) {
  if (!Number.isFinite(story.clearance[state])) return;
  const box = obstacleBox(story.clearanceObstacle[state]);
  const [x, y, u, v] = shortestLink(broomAt(state, story.clearanceBroom[state]), box);
  context.strokeStyle = colours.least;
  context.lineWidth = 2.5;
  traceLine(context, [x, y, u, v]);
  context.stroke();
  context.lineWidth = 2;
  context.beginPath();
  context.arc(toPageX(u), toPageY(v), 6, 0, 2 * Math.PI);
  context.stroke();
}

/** Numbers the points of the body; which kind of point it counts, the first label says. */
function labelOf(point, count) {
  if (story.body === "point") return "point";
  if (story.body === "arm" && point === count - 1) return "tip";
  return point === 0 ? `${story.words.counted} 1` : String(point + 1);
}

function paintPointLabels(context, points) {
  context.font = "600 12px system-ui, sans-serif";
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  context.lineWidth = 3;
  context.strokeStyle = colours.field;
  context.fillStyle = colours.ink;
  for (let i = 0; i < points.length; i += 2) {
    const [x, y] = [toPageX(points[i]) + 7, toPageY(points[i + 1]) - 7];
    const label = labelOf(i / 2, points.length / 2);
    context.strokeText(label, x, y);
    context.fillText(label, x, y);
  }
}

function paintNow(state) {
  const context = layers.chain;
  prepareLayer(context);
  if (story.states === 0) return;
  const points = chainAt(state);
  paintChain(context, points, colours.field, 7, 7);
  paintChain(context, points, colourAlong(shareOf(state)), 3.5, 5);
  paintClearance(context, state);
  for (const violation of story.violated.get(state) || []) paintViolation(context, state, violation);
  if (shown.numbers) paintPointLabels(context, points);
}
