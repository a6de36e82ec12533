// Draws the charts of the page with Chart.js, in the colours of the reader's scheme.
"use strict";

const story = JSON.parse(document.getElementById("data").textContent);
const darkness = matchMedia("(prefers-color-scheme: dark)");
const marks = ["circle", "rect", "triangle", "rectRot", "star", "cross", "crossRot"];

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

const digits = (value) => String(Number(value.toPrecision(4)));

function words(value, quantity) {
  if (quantity === "share") return `${digits(100 * value)} %`;
  if (quantity === "number") return digits(value);
  if (value >= 1) return `${digits(value)} s`;
  return value >= 1e-3 ? `${digits(1e3 * value)} ms` : `${digits(1e6 * value)} µs`;
}

function shade(curve) {
  const planner = story.planners[curve.planner];
  return darkness.matches ? planner.dark : planner.light;
}

function dataset(curve) {
  return {
    curve,
    label: story.planners[curve.planner].label + (curve.line.length === 0 ? " (no curve)" : ""),
    data: curve.line.map(([x, y]) => ({ x, y })),
    borderColor: shade(curve),
    backgroundColor: shade(curve),
    borderWidth: 2,
    pointRadius: curve.line.length === 1 ? 4 : 0,
    pointHoverRadius: 5,
    pointStyle: marks[curve.planner % marks.length],
  };
}

/** Fills the bands of the curves that are shown, below all lines. */
const bands = {
  id: "bands",
  beforeDatasetsDraw(chart) {
    const { ctx, chartArea, scales } = chart;
    ctx.save();
    ctx.beginPath();
    ctx.rect(chartArea.left, chartArea.top, chartArea.width, chartArea.height);
    ctx.clip();
    chart.data.datasets.forEach(({ curve }, i) => {
      if (!chart.isDatasetVisible(i)) return;
      ctx.beginPath();
      for (const [x, y] of curve.band) ctx.lineTo(scales.x.getPixelForValue(x), scales.y.getPixelForValue(y));
      ctx.fillStyle = `${shade(curve)}30`;
      ctx.fill();
    });
    ctx.restore();
  },
};

function scale(axis, titled) {
  const labels = new Map(axis.ticks);
  return {
    type: axis.logarithmic ? "logarithmic" : "linear",
    min: axis.low,
    max: axis.high,
    title: { display: titled, text: axis.name, color: colour("muted") },
    grid: { color: colour("grid"), borderColor: colour("grid") },
    afterBuildTicks: (built) => { built.ticks = axis.ticks.map(([value]) => ({ value })); },
    ticks: { color: colour("muted"), autoSkip: false, maxRotation: 0, callback: (value) => labels.get(value) },
  };
}

function options(panel) {
  return {
    animation: false,
    maintainAspectRatio: false,
    parsing: false,
    interaction: { mode: "nearest", axis: "xy", intersect: false },
    scales: { x: scale(panel.x, true), y: scale(panel.y, false) },
    plugins: {
      legend: { labels: { color: colour("ink"), usePointStyle: true } },
      tooltip: {
        callbacks: {
          title: (items) => (items.length > 0 ? words(items[0].raw.x, panel.x.quantity) : ""),
          label: (item) => `${item.dataset.label}: ${words(item.raw.y, panel.y.quantity)}`,
        },
      },
    },
  };
}

/** Of several panels one is shown, the first one first. */
function chooser(chart, section, show) {
  if (chart.panels.length < 2) return;
  const select = document.createElement("select");
  chart.panels.forEach((panel, i) => select.add(new Option(panel.title, i)));
  select.addEventListener("change", () => show(chart.panels[select.value]));
  const label = document.createElement("label");
  label.append("of", select);
  section.append(label);
}

function addChart(chart) {
  const section = document.createElement("section");
  const heading = document.createElement("h2");
  heading.textContent = chart.title;
  section.append(heading);
  const facts = document.createElement("p");
  const holder = document.createElement("div");
  holder.className = "chart";
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  holder.append(canvas);
  let drawn = null;
  let shown = chart.panels[0];
  const draw = () => {
    drawn?.destroy();
    // Upright it is often longer than the chart is high.
    facts.textContent = [shown.y.name, shown.facts].filter((words) => words !== "").join(" · ");
    canvas.setAttribute("aria-label", `${chart.title}: ${shown.y.name} over ${shown.x.name}; the tables have the figures`);
    drawn = new Chart(canvas, {
      type: "line",
      data: { datasets: shown.curves.map(dataset) },
      options: options(shown),
      plugins: [bands],
    });
  };
  chooser(chart, section, (panel) => { shown = panel; draw(); });
  section.append(facts, holder);
  document.getElementById("charts").append(section);
  draw();
  darkness.addEventListener("change", draw);
}

story.charts.forEach(addChart);
