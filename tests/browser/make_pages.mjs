// Makes the pages under test with the programs: a solved 7ASV with its trees, a spoilt
// solution, a problem alone, one with an awkward name, an arm, a point, very long paths, and a
// gallery.

import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { costs, writeProblem, writeSolution } from "./files.mjs";

const { ASV_PROGRAMS, ASV_OUT, ASV_SOURCE } = process.env;
const pages = join(ASV_OUT, "pages");
const problem = join(ASV_SOURCE, "testcases", "7ASV.txt");
const page = (name) => join(pages, name);

/** Runs a program; codes are the exit codes that are as they should be. */
function run(program, args, codes = [0]) {
  try {
    execFileSync(join(ASV_PROGRAMS, program), args, { stdio: ["ignore", "ignore", "pipe"] });
  } catch (error) {
    if (codes.includes(error.status)) return;
    throw new Error(`${program} ${args.join(" ")}: exit code ${error.status}\n${error.stderr}`);
  }
}

/**
 * Seven ASVs on an arc keep their shape while they go sideways through a wall, and later one of
 * them leaves its place for a few states. This breaks exactly four requirements: steps, cost,
 * broom lengths and collisions; the turns of 36 degrees have room for the leap.
 */
function spoilt(name) {
  const [steps, pace, leap] = [700, 0.0009, 0.004];
  const arc = [[0.13, 0.4]];
  for (let i = 0; i < 6; ++i) {
    const [[x, y], heading] = [arc[i], 0.2 * Math.PI * i - 0.5];
    arc.push([x + 0.05 * Math.cos(heading), y + 0.05 * Math.sin(heading)]);
  }
  const states = [];
  for (let i = 0; i <= steps; ++i) states.push(arc.flatMap(([x, y]) => [x + pace * i, y]));
  const cost = costs(states)[steps];
  for (let i = 600; i < 604; ++i) states[i][4] += leap;
  const walls = ["0.47 0.3 0.5 0.3 0.5 0.5 0.47 0.5", "0.2 0.7 0.8 0.7 0.8 0.75 0.2 0.75"];
  writeProblem(page(`${name}.txt`), { start: states[0], goal: states[steps], walls });
  writeSolution(page(`${name}.solution.txt`), { cost, states });
}

/** n ASVs on an arc that wanders and breathes, in steps just below the limit. */
function wander(n, steps, name) {
  const chain = (t) => {
    const turn = (4.2 + 0.8 * Math.sin(7 * t)) / n;
    let heading = 0.6 * Math.sin(5 * t);
    const points = [[0, 0]];
    for (let i = 1; i < n; ++i) {
      const [x, y] = points[i - 1];
      points.push([x + 0.05 * Math.cos(heading), y + 0.05 * Math.sin(heading)]);
      heading += turn;
    }
    const middle = [0, 1].map((k) => points.reduce((sum, point) => sum + point[k], 0) / n);
    const place = [0.5 + 0.2 * Math.sin(3 * t), 0.5 + 0.2 * Math.sin(2 * t + 0.5)];
    return points.flatMap((point) => point.map((value, k) => value - middle[k] + place[k]));
  };
  const farthest = (a, b) => Math.max(...a.map((_, i) => (i % 2 ? 0 : Math.hypot(b[i] - a[i], b[i + 1] - a[i + 1]))));
  const states = [chain(0)];
  let [time, pace] = [0, 1e-4];
  while (states.length <= steps) {
    const next = chain(time + pace);
    if (farthest(states[states.length - 1], next) > 0.00099) {
      pace *= 0.9;
      continue;
    }
    states.push(next);
    time += pace;
    pace *= 1.05;
  }
  const walls = ["0 0 0.03 0 0.03 0.9 0 0.9", "0.97 0.1 1 0.1 1 1 0.97 1"];
  writeProblem(page(`${name}.txt`), { start: states[0], goal: states[steps], walls });
  writeSolution(page(`${name}.solution.txt`), { cost: costs(states)[steps], states });
  run("asv-view", [page(`${name}.txt`), page(`${name}.solution.txt`), "-o", page(`${name}.html`)]);
}

copyFileSync(problem, page("7ASV.txt"));
run("asv-solve", [problem, page("7ASV.solution.txt"), "--trees", page("7ASV.trees.json"),
                  "--stats", page("7ASV.stats.json"), "--optimize", "0.2", "--quiet"]);
run("asv-view", [problem, page("7ASV.solution.txt"), "--trees", page("7ASV.trees.json"),
                 "--stats", page("7ASV.stats.json"), "-o", page("7ASV.html")]);

spoilt("spoilt");
const spoiltFiles = [page("spoilt.txt"), page("spoilt.solution.txt")];
run("asv-validate", [...spoiltFiles, "--verbose", "--json", page("spoilt.json")], [1]);
run("asv-view", [...spoiltFiles, "-o", page("spoilt.html")]);

run("asv-view", [problem, "-o", page("unsolved.html")]);

const awkward = "<img src=x onerror=alert(1)> & \"quotes\" '@DATA@' <" + "!--";
copyFileSync(problem, page(`${awkward}.txt`));
run("asv-view", [page(`${awkward}.txt`), page("7ASV.solution.txt"), "-o", page("awkward.html")]);
writeFileSync(page("awkward-name.json"), JSON.stringify(awkward));

for (const [name, scenario] of [["arm", "arm-4-workshop"], ["point", "point-town"]]) {
  const file = join(ASV_SOURCE, "testcases", "bodies", `${scenario}.json`);
  run("asv-solve", [file, page(`${name}.solution.txt`), "--optimize", "0.1", "--quiet"]);
  run("asv-view", [file, page(`${name}.solution.txt`), "-o", page(`${name}.html`)]);
}

wander(15, 10000, "long-10000");
wander(15, 30000, "long-30000");
wander(3, 120000, "long-120000");

// Two planners, one with a label that would like to be markup, side by side so that times are spoilt.
run("asv-bench", [...["3ASV.txt", "3ASV-x4.txt"].map((name) => join(ASV_SOURCE, "testcases", name)), "--direction", "both", "--seeds", "3", "--optimize", "0.05",
                  "--jobs", "2", "--planner", "auto", "--planner", `${awkward}: rrt-connect`, "--parameter", "obstacles",
                  "--report", page("report.html"), "--table", page("report.md"), "--quiet"]);

const cases = join(pages, "cases");
mkdirSync(cases, { recursive: true });
for (const name of ["7ASV", "spoilt"]) {
  for (const ending of [".txt", ".solution.txt"]) copyFileSync(page(name + ending), join(cases, name + ending));
}
copyFileSync(join(ASV_SOURCE, "testcases", "15ASV.txt"), join(cases, "15ASV.txt"));
writeFileSync(join(cases, "broken.txt"), "seven\n");
run("asv-view", ["--gallery", join(pages, "gallery"), cases], [3]);
