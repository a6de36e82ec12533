// Clearance and area over the path, and the marks of violated steps above the bar.

const labelWidth = 48;
const rightMargin = 10;
/** Room for the steps below a plot. */
const stepsHeight = 24;
const plotFont = "12px system-ui, sans-serif";

/**
 * One plot: values over the steps, on a scale that maps [0, most] to [0, 1]. What does not change
 * from frame to frame is painted once, into a canvas of its own.
 */
class Plot {
  constructor(id, values, colour, { least = null, root = false }) {
    this.canvas = document.getElementById(id);
    this.context = this.canvas.getContext("2d");
    this.still = document.createElement("canvas").getContext("2d");
    Object.assign(this, { values, colour, least, root });
    this.most = Math.max(values.reduce((a, b) => Math.max(a, b), 0), least ?? 0) || 1;
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.seek(event);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) this.seek(event);
    });
  }

  seek(event) {
    const box = this.canvas.getBoundingClientRect();
    const share = (event.clientX - box.left - labelWidth) / (box.width - labelWidth - rightMargin);
    goTo(Math.round(clamp(share, 0, 1) * story.lastStep));
  }

  xOfStep(step) {
    return labelWidth + (step / Math.max(story.lastStep, 1)) * (this.width - labelWidth - rightMargin);
  }

  x(state) {
    return this.xOfStep(story.steps[state]);
  }

  y(value) {
    const share = clamp(value / this.most, 0, 1);
    return this.height - stepsHeight - (this.root ? Math.sqrt(share) : share) * (this.height - stepsHeight - 10);
  }

  resize() {
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    prepare(this.context, this.width, this.height);
    prepare(this.still, this.width, this.height);
    this.paintScale();
    this.paintCurve();
    this.paintViolations();
  }

  line(fromX, fromY, toX, toY, colour, dashes) {
    this.still.strokeStyle = colour;
    this.still.lineWidth = 1;
    this.still.setLineDash(dashes);
    this.still.beginPath();
    this.still.moveTo(fromX, fromY);
    this.still.lineTo(toX, toY);
    this.still.stroke();
    this.still.setLineDash([]);
  }

  level(value, colour, dashes = []) {
    this.line(labelWidth, this.y(value), this.width - rightMargin, this.y(value), colour, dashes);
  }

  paintScale() {
    const context = this.still;
    context.font = plotFont;
    context.textAlign = "right";
    context.textBaseline = "middle";
    context.fillStyle = colours.muted;
    for (const value of roundNumbers(this.most, (v) => this.y(v))) {
      this.level(value, colours.grid);
      context.fillText(String(value), labelWidth - 5, this.y(value));
    }
    context.textAlign = "center";
    for (const step of roundSteps(story.lastStep, (this.width - labelWidth) / 75)) {
      const x = this.xOfStep(step);
      this.line(x, this.y(0), x, this.y(0) + 4, colours.muted, []);
      const words = grouped(step);
      const half = context.measureText(words).width / 2;
      context.fillText(words, Math.min(x, this.width - half - 1), this.height - 10);
    }
  }

  /** For each pixel column the least and the greatest value: no peak is lost. */
  paintCurve() {
    const context = this.still;
    context.strokeStyle = colours[this.colour];
    context.lineWidth = 1.6;
    context.beginPath();
    for (let state = 0; state < story.states;) {
      const column = Math.floor(this.x(state));
      let [low, high] = [Infinity, -Infinity];
      for (; state < story.states && Math.floor(this.x(state)) === column; ++state) {
        low = Math.min(low, this.values[state]);
        high = Math.max(high, this.values[state]);
      }
      context.lineTo(column, this.y(high));
      context.lineTo(column, this.y(low));
    }
    context.stroke();
    if (this.least !== null) this.level(this.least, colours.ink, [5, 4]);
  }

  paintViolations() {
    this.still.fillStyle = colours.violation;
    for (const state of story.violated.keys()) this.still.fillRect(this.x(state) - 1, 0, 2, 6);
  }

  paint(state) {
    const context = this.context;
    context.clearRect(0, 0, this.width, this.height);
    context.drawImage(this.still.canvas, 0, 0, this.width, this.height);
    context.strokeStyle = colours.ink;
    context.lineWidth = 1.2;
    context.beginPath();
    context.moveTo(this.x(state), 4);
    context.lineTo(this.x(state), this.y(0) + 4);
    context.stroke();
    context.fillStyle = colours[this.colour];
    context.beginPath();
    context.arc(this.x(state), this.y(this.values[state]), 4.5, 0, 2 * Math.PI);
    context.fill();
  }
}

/** 0 and the numbers 1, 2, 5 times powers of ten up to most whose labels do not touch. */
function roundNumbers(most, y) {
  const numbers = [];
  let last = -Infinity;
  for (let power = Math.ceil(Math.log10(most)); power > Math.log10(most) - 4; --power) {
    for (const part of [1, 0.5, 0.2]) {
      const value = Number((part * 10 ** power).toPrecision(1));
      if (value > most || y(value) < last + 18 || y(value) > y(0) - 18) continue;
      numbers.push(value);
      last = y(value);
    }
  }
  return [...numbers, 0];
}

/** Multiples of 1, 2 or 5 times a power of ten from 0 to last, no more than count of them but 0. */
function roundSteps(last, count) {
  const power = 10 ** Math.floor(Math.log10(Math.max(last / count, 1)));
  const gap = [1, 2, 5, 10].map((part) => part * power).find((size) => last / size <= count) ?? last;
  return Array.from({ length: Math.floor(last / gap) + 1 }, (_, i) => i * gap);
}

function paintMarks() {
  const context = document.getElementById("marks").getContext("2d");
  const width = context.canvas.clientWidth;
  prepare(context, width, context.canvas.clientHeight);
  context.fillStyle = colours.violation;
  // The thumb of the bar keeps half its width away from both ends.
  const inset = 8;
  for (const state of story.violated.keys()) {
    const x = inset + (story.steps[state] / Math.max(story.lastStep, 1)) * (width - 2 * inset);
    context.fillRect(x - 1, 0, 2, context.canvas.clientHeight);
  }
}

function makePlots() {
  const plots = [];
  const wanted = [
    ["clearance", story.clearance, "least", { root: true }],
    ["area", story.area, "goal", { least: story.minimumArea }],
  ];
  for (const [name, values, colour, options] of wanted) {
    if (story.states > 0 && Number.isFinite(values[0])) {
      plots.push(new Plot(`plot-${name}`, values, colour, options));
    } else {
      document.getElementById(`plot-${name}`).hidden = true;
      document.getElementById(`label-${name}`).hidden = true;
    }
  }
  document.getElementById("plots").hidden = plots.length === 0;
  return plots;
}
