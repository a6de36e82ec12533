#!/usr/bin/env python3
"""What the programs write as JSON is what docs/schemas/ says, whatever the outcome; and the schemas refuse
the same with a member too many or too few. Usage: outputs_test.py ROOT PROGRAMS"""

import json
import os
import tempfile
from pathlib import Path

from kit import Draft202012Validator, end, expect, fault_of, places, programs, root, run, schemas, value_at, \
    with_value, without

FAMILIES = ["corridor", "bend", "gauntlet", "rooms", "maze", "spiral", "crossing", "clutter"]
CASES = root / "testcases"
MOST_CHANGES = 120  # of one document, each of which is held against its schema
seen = {name: [] for name in schemas}


def take(file, schema):
    """Holds the file against the schema, and keeps it for later."""
    value = json.loads(Path(file).read_text())
    fault = fault_of(value, schema)
    expect(fault is None, f"{schema}: {file}: {fault}")
    seen[schema].append(value)


def solve(problem, *options, code=0):
    run("asv-solve", problem, "s.txt", "--threads", 1, "--optimize", 0, "--quiet", "--stats", "stats.json",
        "--trees", "trees.json", *options, code=code)
    take("stats.json", "statistics")
    # Without time for them there are no trees.
    if Path("trees.json").exists():
        take("trees.json", "trees")
        Path("trees.json").unlink()


def outputs_of_solve():
    for name in ("3ASV.txt", "bodies/arm-3-workshop.json", "bodies/point-town.json", "bodies/chain-by-hand.json"):
        solve(CASES / name)
    solve(CASES / "3ASV.txt", "--planner", "prm-random", "--set", "samples=300", "--set", "neighbours=5", code=None)
    solve(CASES / "bodies" / "point-town.json", "--planner", "prm-grid")
    for name in ("opposite-orientation.txt", "two-asvs.txt", "enclosed-goal.txt"):
        solve(CASES / "infeasible" / name, code=4)
    solve(CASES / "15ASV.txt", "--planner", "rrt", "--time-limit", 0.05, code=1)
    expect({run["status"] for run in seen["statistics"]} == {"solved", "timeout", "infeasible"},
           "not every status was met")
    expect(any("edges" in trees for trees in seen["trees"]), "there was no roadmap")


def outputs_of_validate():
    for name in ("3ASV.txt", "bodies/arm-3-workshop.json", "bodies/point-town.json"):
        run("asv-solve", CASES / name, "s.txt", "--threads", 1, "--optimize", 0, "--quiet")
        for options in ([CASES / name], [CASES / name, "s.txt", "--continuous"]):
            run("asv-validate", *options, "--json", "v.json")
            take("v.json", "validation")
    # A path of another problem, and every start and goal that violates a requirement.
    run("asv-validate", CASES / "3ASV-x4.txt", "s.txt", "--json", "v.json", code=None)
    run("asv-solve", CASES / "3ASV-maze.txt", "s.txt", "--threads", 1, "--optimize", 0, "--quiet")
    run("asv-validate", CASES / "3ASV.txt", "s.txt", "--verbose", "--continuous", "--json", "v.json", code=1)
    take("v.json", "validation")
    for file in sorted((CASES / "invalid").glob("start-*.txt")):
        Path("v.json").unlink(missing_ok=True)
        run("asv-validate", file, "--json", "v.json", "--verbose", code=None)
        if Path("v.json").exists():
            take("v.json", "validation")
    expect(sum(not value["valid"] for value in seen["validation"]) >= 9, "too little was not valid")


def outputs_of_batches():
    queries = [{}, {"id": "far", "goal": {"shape": "arc", "at": [0.85, 0.5], "heading": 90, "orientation": "clockwise"}},
               {"id": 3, "goal": [[0, 0]]}]
    for number, query in enumerate(queries):
        Path("line.json").write_text(json.dumps(query))
        take("line.json", "query")
    Path("q.jsonl").write_text("".join(f"{json.dumps(query)}\n" for query in queries))
    worlds = ["bodies/chain-by-hand.json", "bodies/arm-3-workshop.json", "bodies/point-town.json"]
    for world in worlds:
        run("asv-solve", "--batch", "q.jsonl", CASES / world, "answers.jsonl", "--optimize", 0, "--quiet", code=3)
        for answer in Path("answers.jsonl").read_text().splitlines():
            Path("line.json").write_text(answer)
            take("line.json", "answer")
    expect({answer["status"] for answer in seen["answer"]} >= {"solved", "error"}, "not every status was met")


def outputs_of_trajectories():
    limits = {"speed": 0.1, "acceleration": 1}
    Path("p.json").write_text(json.dumps({"version": 1, "body": {"kind": "point"}, "start": [0, 0], "goal": [0.002, 0],
                                          "bounds": None, "limits": limits}))
    run("asv-solve", "p.json", "s.txt", "--quiet", "--trajectory", "t.json")
    take("t.json", "trajectory")
    # Too slow, and laid out otherwise, so that nobody knows a line.
    Path("t.json").write_text(json.dumps(seen["trajectory"][0], indent=1))
    run("asv-validate", "p.json", "s.txt", "--trajectory", "t.json", "--speed", 0.01, "--json", "v.json", code=1)
    take("v.json", "validation")
    expect(seen["validation"][-1]["parts"][1]["checks"][2]["worst"]["line"] is None, "a line is known")


def outputs_of_certificates():
    problems = sorted((CASES / "infeasible").glob("*.txt"))
    for number, words in enumerate((["corridor", "-n", 3, "--height-factor", 0.9], ["corridor", "-n", 3, "--height-factor", 0.97])):
        run("asv-generate", *words, "--seed", 3, "--quiet", "-o", f"low-{number}.txt")
        problems.append(f"low-{number}.txt")
    # Two boxes that touch each other and the border.
    Path("seams.json").write_text(json.dumps({
        "version": 1, "body": {"kind": "chain", "asv_count": 3}, "start": [[0.1, 0.2], [0.1, 0.15], [0.15, 0.15]],
        "goal": [[0.8, 0.2], [0.8, 0.15], [0.85, 0.15]], "obstacles": [[[0.5, 0], [0.6, 0.5]], [[0.5, 0.5], [0.6, 1]]]}))
    for problem in [*problems, "seams.json"]:
        run("asv-solve", problem, "s.txt", "--quiet", "--certificate", "c.json", code=4)
        take("c.json", "certificate")
        run("asv-validate", problem, "--certificate", "c.json", "--json", "v.json")
        take("v.json", "verdict")
    expect({value["reason"] for value in seen["certificate"]} ==
           {"no_area", "opposite_orientation", "separated", "corridor_too_low"}, "not every reason was met")
    expect(any(value["proof"].get("seams") for value in seen["certificate"]), "there was no seam")
    run("asv-validate", CASES / "3ASV.txt", "--certificate", "c.json", "--json", "v.json", code=1)
    take("v.json", "verdict")


def outputs_of_generate():
    for family in FAMILIES:
        run("asv-generate", "-n", 3, "--seed", 2, "--solvable", "--quiet", "-o", "p.txt", family)
        take("p.txt.json", "generation")
    run("asv-generate", "-n", 3, "--infeasible", "turned", "--solvable", "--quiet", "-o", "p.txt", "clutter")
    take("p.txt.json", "generation")
    # Between what is proven and what is found.
    run("asv-generate", "-n", 3, "--solvable", "--quiet", "-o", "p.txt", "bend", "--bends", 1, "--height-factor", 1.3)
    take("p.txt.json", "generation")
    scenario = json.loads((CASES / "bodies" / "chain-by-hand.json").read_text())
    del scenario["goal"]
    Path("start.json").write_text(json.dumps(scenario))
    run("asv-generate", "--from", "start.json", "--solvable", "--quiet", "-o", "p.json")
    take("p.json.json", "generation")
    take("p.json", "scenario")
    expect({value["verdict"] for value in seen["generation"]} == {"solvable", "infeasible", "unknown"}, "not all verdicts")


def outputs_of_bench():
    problems = [CASES / "3ASV.txt", CASES / "bodies" / "arm-3-workshop.json", "generate: clutter -n 3 --seed 3"]
    planners = ["--planner", "auto", "--planner", "tree: rrt goal-bias=0.1", "--planner", "no: exec false {problem} {solution}",
                "--planner", "other: exec asv-solve {problem} {solution} --seed {seed} --time-limit {time} --optimize 0 --quiet"]
    run("asv-bench", *problems, *planners, "--seeds", 2, "--direction", "both", "--time-limit", 1, "--resume", "j.jsonl",
        "--json", "b.json", "--quiet")
    take("b.json", "benchmark")
    # The journal goes on with a run that was lost; then the runs of two files are put together.
    journal = Path("j.jsonl").read_text().splitlines()
    runs = [line for line in journal if line.startswith('{"problem"')]
    Path("j.jsonl").write_text("\n".join([journal[0], *runs[:-1]]) + "\n")
    run("asv-bench", *problems, *planners, "--seeds", 2, "--direction", "both", "--time-limit", 1, "--resume", "j.jsonl",
        "--quiet")
    for number, line in enumerate(Path("j.jsonl").read_text().splitlines(), start=1):
        Path("line.json").write_text(line)
        take("line.json", "journal_line")
    kinds = {next(iter(line)) for line in seen["journal_line"]}
    expect(kinds == {"format", "problem", "session", "session_end"}, f"the journal has lines of {kinds}")
    run("asv-bench", CASES / "3ASV.txt", "--seeds", 1, "--first-seed", 3, "--planner", "auto", "--time-limit", 1,
        "--json", "c.json", "--quiet")
    run("asv-bench", CASES / "3ASV.txt", "--seeds", 2, "--planner", "auto", "--time-limit", 1, "--json", "d.json", "--quiet")
    run("asv-bench", "--from", "c.json", "--from", "d.json", "--json", "b.json", "--quiet")
    take("b.json", "benchmark")
    expect(seen["benchmark"][-1]["session"]["parts"], "nothing was put together")


def expect_refused_when_changed(name):
    """No schema that takes anything: each object of a document with a member more, and without each."""
    value = max(seen[name], key=lambda value: len(json.dumps(value)) if name != "trees" else "edges" in value)
    if name == "trees":
        value = {**value, "trees": [{**tree, "points": tree["points"][:2], "parents": tree["parents"][:2]}
                                    for tree in value["trees"]], "edges": value["edges"][:2]}
    free = ("parameters", "settings")  # whose members have any names
    for at in list(places(value))[:MOST_CHANGES]:
        here = value_at(value, at)
        if isinstance(here, dict) and (not at or at[-1] not in free):
            expect(fault_of(with_value(value, at, {**here, "surplus": 1}), name) is not None,
                   f"{name}: a surplus member at {at} is taken")
    optional = ("id", "edges", "asv", "broom", "obstacle", "time", "parameters")
    for at in list(places(value))[1:MOST_CHANGES]:
        if isinstance(at[-1], str) and at[-1] not in optional and not set(at[:-1]) & set(free):
            expect(fault_of(without(value, at), name) is not None, f"{name}: nothing at {at} is taken")


def main():
    for name, schema in schemas.items():
        Draft202012Validator.check_schema(schema)
    os.environ["PATH"] = f"{programs}:{os.environ['PATH']}"
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for write in (outputs_of_solve, outputs_of_batches, outputs_of_validate, outputs_of_trajectories, outputs_of_certificates,
                      outputs_of_generate, outputs_of_bench):
            write()
        os.chdir(root)
    for name in schemas:
        if name in ("scenario", "query"):  # that are read
            continue
        expect(seen[name], f"nothing is written as {name}")
        expect_refused_when_changed(name)
    end()


main()
