#!/usr/bin/env python3
"""What --trajectory adds to asv-solve, on paths with many steps, and how long the trajectories take.

trajectories.py STEP PROBLEM...: each problem file of the classic format is planned with primitive steps of
that length, without improvement, by turns with and without a trajectory as CSV; the least processor time of
several runs counts. Prints a table in Markdown.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROUNDS = 7
PROGRAM = pathlib.Path(__file__).parents[2] / "build/release/bin/asv-solve"
LIMITS = {"speed": 0.05, "acceleration": 0.02}


def scenario(problem, step):
    lines = problem.read_text().split("\n")
    count = int(lines[0].split()[0])

    def numbers(line, wanted):
        return [float(word) for word in line.split()[:wanted]]

    def state(line):
        values = numbers(line, 2 * count)
        return [list(point) for point in zip(values[::2], values[1::2])]

    obstacles = []
    for line in lines[4:4 + int(lines[3].split()[0])]:
        xs, ys = numbers(line, 8)[::2], numbers(line, 8)[1::2]
        obstacles.append([[min(xs), min(ys)], [max(xs), max(ys)]])
    return {"version": 1, "body": {"kind": "chain"}, "start": state(lines[1]), "goal": state(lines[2]),
            "obstacles": obstacles, "step": step, "limits": LIMITS}


def run(arguments):
    """Processor seconds, and what it says."""
    process = subprocess.Popen(arguments, stderr=subprocess.PIPE, text=True)
    words = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"asv-solve failed: {words}")
    return usage.ru_utime + usage.ru_stime, words


def main():
    step = float(sys.argv[1])
    print("| problem | steps | trajectory, s | without, ms | with, ms | file, MB |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        given, solution, file = (os.path.join(folder, name) for name in ("p.json", "s.txt", "t.csv"))
        for problem in map(pathlib.Path, sys.argv[2:]):
            pathlib.Path(given).write_text(json.dumps(scenario(problem, step)))
            plain = [PROGRAM, given, solution, "--threads", "1", "--optimize", "0"]
            least = [float("inf"), float("inf")]
            for _ in range(ROUNDS):
                for i, arguments in enumerate((plain, plain + ["--trajectory", file])):
                    seconds, words = run(arguments)
                    least[i] = min(least[i], seconds)
            steps = int(pathlib.Path(solution).read_text().split()[0])
            duration = words.split("trajectory: ")[1].split()[0]
            print(f"| {problem.stem} | {steps} | {duration} | {1e3 * least[0]:.0f} | {1e3 * least[1]:.0f} | "
                  f"{os.path.getsize(file) / 1e6:.1f} |")


main()
