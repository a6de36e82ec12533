#!/usr/bin/env python3
"""Makes the benchmark set, testcases/set/problems.csv, and tables of it.

    benchmark_set.py make                 the file anew: names and words; what is known of a problem
                                          whose words are the same is kept
    benchmark_set.py update RUNS.json...  least costs and greatest bounds of runs (asv-bench --json)
                                          go into the file where they are better
    benchmark_set.py table                what is in the set, by family
    benchmark_set.py results RUNS.json    how planners did, by family and number of ASVs

RUNS.json: - is standard input. Nothing is drawn or planned here.
"""

import csv
import decimal
import io
import json
import pathlib
import statistics
import string
import sys

FILE = pathlib.Path(__file__).parents[2] / "testcases/set/problems.csv"
TITLES = ["name", "words", "n", "feasible", "best_cost", "lower_bound"]

# For each family: options, and the numbers of ASVs with which they are drawn.
FEASIBLE = {
    "corridor": [
        ("--height-factor 1.3", [1, 3, 4, 5, 6, 7, 8, 9, 10]),
        ("--height-factor 1.1", [4, 5, 7, 8, 10]),
        ("--height-factor 1.02", [5, 7, 9, 10]),
        ("--height 0.06", [12, 15, 18, 21, 24, 27]),
        ("--height 0.03", [11, 12, 14, 15, 17, 20]),
        ("--height 0.015", [12, 13, 16, 18, 19]),
    ],
    "bend": [
        ("--bends 1", [1, 3, 4, 5, 6, 7, 8, 9, 10]),
        ("--bends 2", [3, 4, 5, 6, 7, 8]),
        ("--bends 2 --height-factor 4", [3, 4, 5, 6, 7, 8, 9]),
        ("--bends 3 --height-factor 4", [3, 4, 5, 6]),
        ("--bends 1 --height-factor 2", [4, 5, 6, 7, 8, 9, 10, 11, 12]),
    ],
    "gauntlet": [
        ("--walls 1", [1, 3, 5, 7, 9, 11, 13, 15]),
        ("--walls 2", [3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16]),
        ("--walls 3", [3, 4, 5, 6, 7, 8, 10]),
        ("--walls 4 --thickness 0.05", [3, 4, 5, 6]),
        ("--walls 1 --height 0.02", [12, 14, 16, 17, 18]),
    ],
    "rooms": [
        ("", [1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]),
        ("--rooms 2 --shelves 4", [3, 5, 7, 9, 11, 13, 16, 18, 20, 22]),
        ("--rooms 4 --doors 1 --shelves 0", [3, 4, 5, 6, 7, 8]),
        ("--rooms 3 --doors 3 --shelves 6 --height-factor 2", [3, 5, 7, 9, 11]),
    ],
    "maze": [
        ("", [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18]),
        ("--way-factor 1.3", [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14]),
        ("--way-factor 1.6", [1, 3, 5, 7, 9, 11, 13]),
    ],
    "spiral": [
        ("", [1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14]),
        ("--way-factor 1.3", [3, 4, 5, 6, 7, 8, 9, 10, 11, 12]),
        ("--way-factor 1.6 --wall 0.02", [3, 4, 5, 6, 7, 8, 9, 10, 11, 12]),
        ("--legs 4", [3, 5]),
    ],
    "crossing": [
        ("", [1, 3, 5, 8, 12, 15, 18, 20, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40, 42, 44, 46, 48, 50]),
        ("--road-factor 0.9", [19, 21, 23, 25, 27, 29]),
        ("--road 0.2", [4, 6, 9, 10, 11, 14]),
    ],
    "clutter": [
        ("--obstacles 3 --density 0.03", [1, 30, 31, 33, 35, 37, 39, 41, 43, 45, 47, 49, 50]),
        ("", [3, 6, 9, 12, 17, 21, 25]),
        ("--obstacles 100", [3, 5, 7, 8, 10, 12]),
        ("--obstacles 1000", [3, 4]),
        ("--obstacles 40 --density 0.08 --lane 0", [4, 6, 9, 13, 16, 18, 20]),
    ],
}

# No path, and why: a goal that turns the other way or stands in a fence (asv-solve proves both); a
# corridor as long as the chain in which it cannot enclose the area that it must.
INFEASIBLE = {
    "turned": ("--infeasible turned", [("corridor", 7), ("bend", 5), ("gauntlet", 6), ("rooms", 9),
                                       ("maze", 4), ("crossing", 30), ("clutter", 16)]),
    "fenced": ("--infeasible fenced", [("bend", 6), ("gauntlet", 4), ("rooms", 5), ("maze", 8),
                                       ("spiral", 3), ("crossing", 12), ("clutter", 10)]),
    "low": ("--height-factor 0.4", [("corridor", n) for n in (3, 4, 5, 6, 8, 10)]),
}

# Problems whose first seed gives no room, or one that the default planner does not solve soon.
OTHER_SEEDS = {"bend-05e": 2}


def problems():
    """Name, words, n and whether there is a path, by family and n."""
    for family, kinds in FEASIBLE.items():
        used = {}
        entries = sorted(((n, kind) for kind, (_, ns) in enumerate(kinds) for n in ns))
        for n, kind in entries:
            letter = string.ascii_lowercase[used.setdefault(n, 0)]
            used[n] += 1
            yield problem(family, f"{family}-{n:02}{letter}", n, kinds[kind][0], True)
        for cause, (options, which) in INFEASIBLE.items():
            for n in sorted(n for name, n in which if name == family):
                yield problem(family, f"{family}-{n:02}-{cause}", n, options, False)


def problem(family, name, n, options, feasible):
    words = [family, "-n", str(n), *options.split(), "--seed", str(OTHER_SEEDS.get(name, 1))]
    return {"name": name, "words": " ".join(words), "n": str(n),
            "feasible": "feasible" if feasible else "infeasible", "best_cost": "", "lower_bound": ""}


def read_set():
    with open(FILE, encoding="ascii") as file:
        return list(csv.DictReader(file))


def write_set(rows):
    text = io.StringIO()
    writer = csv.DictWriter(text, TITLES, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    FILE.write_text(text.getvalue(), encoding="ascii")


def make():
    known = {row["words"]: row for row in read_set()} if FILE.exists() else {}
    rows = list(problems())
    for row in rows:
        for key in ("best_cost", "lower_bound"):
            row[key] = known.get(row["words"], row)[key]
    write_set(rows)


def rounded(value, rounding):
    return str(decimal.Decimal(value).quantize(decimal.Decimal("0.000001"), rounding))


def update(reports):
    rows = {"generate: " + row["words"]: row for row in read_set()}
    for report in reports:
        files = {p["name"]: p["file"] for p in report["problems"]}
        for run in report["runs"]:
            row = rows.get(files[run["problem"]])
            if row is None:
                continue
            if run["status"] == "solved":
                if row["feasible"] != "feasible":
                    raise SystemExit(row["name"] + " is solved, and has no path")
                cost = rounded(run["cost"], decimal.ROUND_CEILING)
                if not row["best_cost"] or float(cost) < float(row["best_cost"]):
                    row["best_cost"] = cost
            if run["cost_lower_bound"] is not None and row["feasible"] == "feasible":
                bound = rounded(run["cost_lower_bound"], decimal.ROUND_FLOOR)
                if not row["lower_bound"] or float(bound) > float(row["lower_bound"]):
                    row["lower_bound"] = bound
    write_set(rows.values())


def table():
    print("| family | problems | without a path | n | best cost / bound, median | worst |\n|---|---:|---:|---|---:|---:|")
    rows = read_set()
    for family in [*FEASIBLE, ""]:
        mine = [row for row in rows if row["words"].startswith(family)]
        ratios = [float(row["best_cost"]) / float(row["lower_bound"])
                  for row in mine if row["best_cost"] and row["lower_bound"]]
        ns = [int(row["n"]) for row in mine]
        print(f"| {family or 'all'} | {len(mine)} | {sum(r['feasible'] != 'feasible' for r in mine)} | "
              f"{min(ns)} to {max(ns)} | {statistics.median(ratios):.3f} | {max(ratios):.3f} |")


def results(report):
    """A row for each planner: of its runs on problems that have a path those that are solved,
    forward + reversed, by families and numbers of ASVs; then the median time to the first path."""
    feasible = {"generate: " + row["words"] for row in read_set() if row["feasible"] == "feasible"}
    problems_ = {p["name"]: p for p in report["problems"] if p["file"] in feasible}
    directions = report["session"]["directions"]
    groups = {family: {n for n, p in problems_.items() if p["file"].split()[1] == family}
              for family in FEASIBLE}
    for low, high in ((1, 5), (6, 10), (11, 20), (21, 50)):
        groups[f"n = {low} to {high}"] = {n for n, p in problems_.items()
                                          if low <= p["asv_count"] <= high}
    groups["all"] = set(problems_)
    groups = {name: members for name, members in groups.items() if members}

    print("| planner | " + " | ".join(groups) + " | median ms |\n|---|" + "---:|" * (len(groups) + 1))
    each = [len(members) * report["session"]["seeds"] for members in groups.values()]
    print("| runs | " + " | ".join(" + ".join([str(count)] * len(directions)) for count in each) + " | |")
    for planner in report["planners"]:
        runs = [run for run in report["runs"]
                if run["planner"] == planner["label"] and run["problem"] in problems_]
        solved = [run for run in runs if run["status"] == "solved"]
        cells = [" + ".join(str(sum(run["problem"] in members and run["direction"] == direction
                                    for run in solved)) for direction in directions)
                 for members in groups.values()]
        cells.append(median_time(runs, report["session"]["time_limit_s"]))
        print(f"| {planner['label']} | " + " | ".join(cells) + " |")


def median_time(runs, limit):
    """In milliseconds; runs that are not solved count as longer than the limit."""
    median = statistics.median_high(
        run["time_to_first_s"] if run["status"] == "solved" else float("inf") for run in runs)
    return f">{1000 * limit:.0f}" if median > limit else f"{1000 * median:.1f}"


def read_json(name):
    return json.load(sys.stdin if name == "-" else open(name, encoding="utf-8"))


def main(mode, *files):
    if mode == "make":
        make()
    elif mode == "update":
        update([read_json(name) for name in files])
    elif mode == "table":
        table()
    elif mode == "results":
        results(read_json(files[0]))
    else:
        raise SystemExit(__doc__)


main(*(sys.argv[1:] or ["help"]))
