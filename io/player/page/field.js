// Paints the ground: the lowest of the three layers of the field, which changes only with the view.
// The trail that grows while playing and the chain, in moving.js, change from frame to frame.

const layers = {
  ground: document.getElementById("layer-ground").getContext("2d"),
  trail: document.getElementById("layer-trail").getContext("2d"),
  chain: document.getElementById("layer-chain").getContext("2d"),
};

const shown = { trails: true, trees: true, numbers: false };

/** The colours of the style sheet, as the reader's scheme has them. */
let colours = {};

function readColours() {
  const style = getComputedStyle(document.documentElement);
  colours = {};
  for (const name of ["page", "field", "ink", "muted", "grid", "obstacle", "start", "goal", "least", "violation"]) {
    colours[name] = style.getPropertyValue(`--${name}`).trim();
  }
}

/** The colour between start and goal at a share of the cost. */
function colourAlong(share) {
  const channels = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
  const [start, goal] = [channels(colours.start), channels(colours.goal)];
  return `rgb(${start.map((c, i) => Math.round(c + (goal[i] - c) * share)).join(" ")})`;
}

const shareOf = (state) => story.cost[state] / (story.cost[story.states - 1] || 1);

/** Makes a canvas as sharp as the screen, cleared, with the page's pixels as its unit. */
function prepare(context, width, height) {
  const density = Math.min(window.devicePixelRatio || 1, 2);
  const canvas = context.canvas;
  const [wide, high] = [Math.round(width * density), Math.round(height * density)];
  if (canvas.width !== wide || canvas.height !== high) {
    canvas.width = wide;
    canvas.height = high;
  }
  context.setTransform(density, 0, 0, density, 0, 0);
  context.clearRect(0, 0, width, height);
  context.lineCap = context.lineJoin = "round";
}

const prepareLayer = (context) => prepare(context, camera.size, camera.size);

function traceLine(context, points) {
  context.beginPath();
  for (let i = 0; i < points.length; i += 2) context.lineTo(toPageX(points[i]), toPageY(points[i + 1]));
}

function fillDot(context, x, y, radius) {
  context.beginPath();
  context.arc(toPageX(x), toPageY(y), radius, 0, 2 * Math.PI);
  context.fill();
}

/** Links, for ASVs the closing side dashed, and a dot for each point; the first has an eye. */
function paintChain(context, points, colour, width, radius) {
  context.strokeStyle = context.fillStyle = colour;
  if (points.length > 4 && story.body === "chain") {
    context.save();
    context.globalAlpha = 0.75;
    context.lineWidth = Math.max(width / 2, 1);
    context.setLineDash([3, 5]);
    traceLine(context, [points[points.length - 2], points[points.length - 1], points[0], points[1]]);
    context.stroke();
    context.restore();
  }
  context.lineWidth = width;
  traceLine(context, points);
  context.stroke();
  for (let i = 0; i < points.length; i += 2) fillDot(context, points[i], points[i + 1], radius);
  context.fillStyle = colours.field;
  fillDot(context, points[0], points[1], radius / 2);
}

function paintGrid(context) {
  const [lowX, lowY, highX, highY] = story.bounds;
  context.strokeStyle = colours.grid;
  context.lineWidth = 1;
  context.beginPath();
  for (let i = 1; i < 10; ++i) {
    const x = toPageX(lowX + ((highX - lowX) * i) / 10);
    const y = toPageY(lowY + ((highY - lowY) * i) / 10);
    context.moveTo(x, toPageY(lowY));
    context.lineTo(x, toPageY(highY));
    context.moveTo(toPageX(lowX), y);
    context.lineTo(toPageX(highX), y);
  }
  context.stroke();
  context.strokeStyle = colours.muted;
  context.lineWidth = 1.5;
  context.strokeRect(toPageX(lowX), toPageY(highY), (highX - lowX) * scaleOf(), (highY - lowY) * scaleOf());
}

function paintObstacles(context) {
  context.fillStyle = colours.obstacle;
  context.strokeStyle = colours.muted;
  context.lineWidth = 1.4;
  context.beginPath();
  for (let i = 0; 4 * i < story.obstacles.length; ++i) {
    const [lowX, lowY, highX, highY] = obstacleBox(i);
    context.rect(toPageX(lowX), toPageY(highY), (highX - lowX) * scaleOf(), (highY - lowY) * scaleOf());
  }
  // The filling hides the lines between boxes that touch: their union is outlined.
  context.stroke();
  context.fill();
}

function paintObstacleNumbers(context) {
  context.fillStyle = colours.ink;
  context.font = "600 13px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (let i = 0; 4 * i < story.obstacles.length; ++i) {
    const [lowX, lowY, highX, highY] = obstacleBox(i);
    if (Math.min(highX - lowX, highY - lowY) * scaleOf() < 16) continue;
    context.fillText(i + 1, toPageX((lowX + highX) / 2), toPageY((lowY + highY) / 2));
  }
}

function paintTree(context, tree) {
  const colour = { start: colours.start, goal: colours.goal, roadmap: colours.least }[tree.kind];
  const { points, parents, edges } = tree;
  const link = (i, j) => {
    context.moveTo(toPageX(points[2 * i]), toPageY(points[2 * i + 1]));
    context.lineTo(toPageX(points[2 * j]), toPageY(points[2 * j + 1]));
  };
  context.save();
  context.strokeStyle = context.fillStyle = colour;
  context.globalAlpha = 0.5;
  context.lineWidth = 0.8;
  const size = 1000; // one path of all edges would be slow to stroke
  for (let first = 0; first < parents.length; first += size) {
    context.beginPath();
    const end = Math.min(first + size, parents.length);
    for (let i = first; i < end; ++i) if (parents[i] >= 0) link(parents[i], i);
    context.stroke();
  }
  for (let first = 0; first < edges.length; first += 2 * size) {
    context.beginPath();
    const end = Math.min(first + 2 * size, edges.length);
    for (let i = first; i < end; i += 2) link(edges[i], edges[i + 1]);
    context.stroke();
  }
  if (tree.kind === "roadmap") {
    for (let i = 0; i < points.length; i += 2) fillDot(context, points[i], points[i + 1], 1.4);
  }
  context.restore();
}

function paintEnd(context, points, colour, word) {
  context.save();
  context.globalAlpha = 0.85;
  paintChain(context, points, colour, 2, 3);
  context.font = "600 14px system-ui, sans-serif";
  context.textAlign = "center";
  context.fillStyle = colour;
  context.strokeStyle = colours.field;
  context.lineWidth = 4;
  let lowest = Infinity;
  let sum = 0;
  for (let i = 0; i < points.length; i += 2) {
    lowest = Math.min(lowest, points[i + 1]);
    sum += points[i];
  }
  const middle = toPageX((2 * sum) / points.length);
  const half = context.measureText(word).width / 2 + 4;
  // Near the border it stands beside the middle rather than being cut off.
  const inView = middle >= 0 && middle <= camera.size;
  const x = inView ? clamp(middle, half, camera.size - half) : middle;
  const y = Math.min(toPageY(lowest) + 20, camera.size - 6);
  context.strokeText(word, x, y);
  context.fillText(word, x, y);
  context.restore();
}

function paintGround() {
  const context = layers.ground;
  prepareLayer(context);
  paintGrid(context);
  paintObstacles(context);
  if (shown.trees) for (const tree of story.trees) paintTree(context, tree);
  if (shown.numbers) paintObstacleNumbers(context);
  if (shown.trails) {
    context.save();
    context.globalAlpha = 0.3;
    context.lineWidth = 1;
    strokeWay(context, 0, story.states - 1);
    context.restore();
  }
  paintEnd(context, story.start, colours.start, "start");
  paintEnd(context, story.goal, colours.goal, "goal");
}
