// Makes the pages under test with the programs: a solved 7ASV with its trees, the same with a
// spoilt solution, a problem alone, one with an awkward name, two very long paths, and a gallery.

import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { costs, readSolution, writeSolution } from "./files.mjs";

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

/** One ASV leaves its place for a few states, and later the whole chain passes through a wall. */
function spoil({ cost, states }) {
  const spoilt = states.map((state) => [...state]);
  const first = Math.floor(states.length * 0.7);
  for (let i = first; i < first + 4; ++i) spoilt[i][4] += 0.004;
  const begin = Math.floor(states.length * 0.4);
  const length = 60;
  for (let i = 0; i <= length; ++i) {
    const shift = 0.06 * Math.sin((Math.PI * i) / length);
    for (let k = 1; k < states[0].length; k += 2) spoilt[begin + i][k] -= shift;
  }
  return { cost, states: spoilt };
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
  writeFileSync(page(`${name}.txt`), [n, states[0].join(" "), states[steps].join(" "), 2, ...walls, ""].join("\n"));
  writeSolution(page(`${name}.solution.txt`), { cost: costs(states)[steps], states });
  run("asv-view", [page(`${name}.txt`), page(`${name}.solution.txt`), "-o", page(`${name}.html`)]);
}

copyFileSync(problem, page("7ASV.txt"));
run("asv-solve", [problem, page("7ASV.solution.txt"), "--trees", page("7ASV.trees.json"),
                  "--stats", page("7ASV.stats.json"), "--optimize", "0.2", "--quiet"]);
run("asv-view", [problem, page("7ASV.solution.txt"), "--trees", page("7ASV.trees.json"),
                 "--stats", page("7ASV.stats.json"), "-o", page("7ASV.html")]);

writeSolution(page("spoilt.solution.txt"), spoil(readSolution(page("7ASV.solution.txt"))));
copyFileSync(problem, page("spoilt.txt"));
run("asv-validate", [problem, page("spoilt.solution.txt"), "--verbose", "--json", page("spoilt.json")], [1]);
run("asv-view", [problem, page("spoilt.solution.txt"), "-o", page("spoilt.html")]);

run("asv-view", [problem, "-o", page("unsolved.html")]);

const awkward = "<img src=x onerror=alert(1)> & \"quotes\" '@DATA@' <" + "!--";
copyFileSync(problem, page(`${awkward}.txt`));
run("asv-view", [page(`${awkward}.txt`), page("7ASV.solution.txt"), "-o", page("awkward.html")]);
writeFileSync(page("awkward-name.json"), JSON.stringify(awkward));

wander(15, 10000, "long-10000");
wander(15, 30000, "long-30000");

const cases = join(pages, "cases");
mkdirSync(cases, { recursive: true });
for (const name of ["7ASV", "spoilt"]) {
  for (const ending of [".txt", ".solution.txt"]) copyFileSync(page(name + ending), join(cases, name + ending));
}
writeFileSync(join(cases, "broken.txt"), "seven\n");
run("asv-view", ["--gallery", join(pages, "gallery"), cases], [3]);
