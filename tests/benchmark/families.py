#!/usr/bin/env python3
"""Solves random problems of the families of asv-generate and prints a table: solved runs, time to
the first path (median, worst), and which problems were not solved.

    families.py PROBLEMS SEEDS SECONDS [NAME]

PROBLEMS of each family, SEEDS runs for each, at most SECONDS a run; NAME: only families whose name
holds it. The first solution of each problem also has to pass asv-validate --continuous. A problem
that no run solved is listed with the generator's verdict (solvable or unknown).
ASV_BIN: folder of the programs. One thread.
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

BIN = pathlib.Path(os.environ.get("ASV_BIN", pathlib.Path(__file__).parents[2] / "build/release/bin"))


def families():
    """Names and arguments of asv-generate for problem p."""
    for n in (4, 5, 7, 10):
        for factor in (1.3, 1.1, 1.03, 1.01):
            yield f"corridor {factor} times the least height, n = {n}", \
                lambda p, n=n, f=factor: ["corridor", "-n", n, "--height-factor", f]
    for n in (12, 15, 20):
        for height in (0.03, 0.02, 0.015):
            yield f"hook through a corridor {height} high, n = {n}", \
                lambda p, n=n, h=height: ["corridor", "-n", n, "--height", h]
    for n in (5, 9):
        for walls in (2, 3):
            yield f"{walls} walls in a row, n = {n}", \
                lambda p, n=n, w=walls: ["gauntlet", "-n", n, "--walls", w]
    for n in (4, 7):
        yield f"corridor with 2 or 3 bends, n = {n}", \
            lambda p, n=n: ["bend", "-n", n, "--bends", 2 + p % 2]
    for n in (3, 5, 8, 12, 16):
        yield f"maze, n = {n}", lambda p, n=n: ["maze", "-n", n]
    for n in (3, 5, 7):
        yield f"spiral, n = {n}", lambda p, n=n: ["spiral", "-n", n]
    for n, boxes in ((3, 5), (3, 1000), (7, 100), (12, 50), (25, 20)):
        yield f"clutter of {boxes} boxes, n = {n}", \
            lambda p, n=n, m=boxes: ["clutter", "-n", n, "--obstacles", m]
    for n in (30, 40, 50):
        yield f"3 obstacles, n = {n}", \
            lambda p, n=n: ["clutter", "-n", n, "--obstacles", 3, "--density", 0.03]
    for n in (7, 15):
        yield f"rooms, n = {n}", lambda p, n=n: ["rooms", "-n", n]
    yield "clutter of 100000 boxes, n = 3", \
        lambda p: ["clutter", "-n", 3, "--obstacles", 100000]


def call(program, *arguments):
    return subprocess.run([BIN / program, *map(str, arguments)], capture_output=True, text=True)


def survey(arguments, problems, seeds, seconds, folder):
    """Solved runs, their times in ms, and what was not solved."""
    problem, solution, stats = (folder / name for name in ("problem.txt", "solution.txt", "stats.json"))
    times, unsolved = [], []
    for p in range(1, problems + 1):
        made = call("asv-generate", *arguments(p), "--seed", p, "-o", problem, "--solvable")
        if made.returncode != 0:
            raise SystemExit(made.stderr)
        solved = 0
        for seed in range(1, seeds + 1):
            run = call("asv-solve", problem, solution, "--threads", 1, "--optimize", 0, "--quiet",
                       "--time-limit", seconds, "--seed", seed, "--stats", stats)
            if run.returncode not in (0, 1):
                raise SystemExit(f"problem {p}, seed {seed}: {run.stderr}")
            if run.returncode == 1:
                continue
            times.append(1000 * json.loads(stats.read_text())["time_to_first_s"])
            if solved == 0 and call("asv-validate", problem, solution, "--continuous").returncode != 0:
                raise SystemExit(f"problem {p}, seed {seed}: not valid")
            solved += 1
        if solved < seeds:
            verdict = json.loads(problem.with_name("problem.txt.json").read_text())["verdict"]
            unsolved.append(f"problem {p}: {solved} of {seeds} ({verdict})")
    return times, unsolved


def main():
    problems, seeds, seconds = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])
    wanted = sys.argv[4] if len(sys.argv) > 4 else ""
    print("| family | solved | median ms | worst ms | not solved |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, arguments in families():
            if wanted not in name:
                continue
            times, unsolved = survey(arguments, problems, seeds, seconds, pathlib.Path(folder))
            middle, worst = (statistics.median(times), max(times)) if times else (0, 0)
            print(f"| {name} | {len(times)} of {problems * seeds} | {middle:.1f} | {worst:.0f} | "
                  f"{'; '.join(unsolved)} |", flush=True)


main()
