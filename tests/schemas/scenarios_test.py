#!/usr/bin/env python3
"""The schema of scenarios takes ours and whatever the programs read, and refuses what they refuse: members
that are unknown, missing or of another type, numbers out of range. Usage: scenarios_test.py ROOT PROGRAMS"""

import json
import shutil
import tempfile
from pathlib import Path

from kit import end, expect, fault_of, places, root, run, value_at, with_value, without

CHAIN = {"version": 1, "body": {"kind": "chain", "broom_length": 0.05, "minimum_area_factor": 0.007},
         "start": [[0.5, 0.5], [0.55, 0.5], [0.55, 0.55]],
         "goal": {"at": [0.1, 0.5], "heading": 90, "turns": [-90]},
         "bounds": [[0, 0], [1, 1]], "obstacles": [[[0.9, 0], [0.95, 1]]], "step": 0.001, "tolerance": 1e-5}
SHAPES = {"version": 1, "body": {"kind": "chain", "asv_count": 7},
          "start": {"shape": "line", "at": [0.1, 0.5], "heading": 0, "orientation": "clockwise"},
          "goal": {"shape": "hook", "at": [0.6, 0.5], "heading": -90, "bend": 90, "leg": 3}, "bounds": None}
ARC = {"version": 1, "unit": "µm", "body": {"kind": "chain"}, "start": [[0, 0], [0.05, 0], [0.05, 0.05]],
       "goal": {"shape": "arc", "at": [0.6, 0.5], "heading": 0, "bend": 100.5}}
ARM = {"version": 1, "body": {"kind": "arm", "base": [1, 0], "links": [2, 1], "angles": "relative",
                              "joints": ["wrap", [-2, 2]]},
       "bounds": None, "start": [0, 1.5], "goal": {"heading": 45, "turns": [-90]}}
LIMITED = {"version": 1, "body": {"kind": "arm", "base": [1, 0], "links": [2], "angles": "absolute", "joints": [0, 3]},
           "bounds": None, "start": [0], "goal": [1]}
POINT = {"version": 1, "body": {"kind": "point"}, "start": [8, 10], "goal": [290, 188], "step": 0.5,
         "map": {"file": "town.png", "threshold": 127, "cell": 1, "origin": [0, 0, 0], "transpose": False,
                 "flip": False},
         "limits": {"speed": 1.5, "acceleration": [0.3]}}
SAMPLES = {"chain": CHAIN, "shapes": SHAPES, "arc": ARC, "arm": ARM, "limited": LIMITED, "point": POINT}

OUT_OF_RANGE = [
    (CHAIN, ("version",), 2), (CHAIN, ("body", "kind"), "disc"), (CHAIN, ("body", "broom_length"), 0),
    (CHAIN, ("body", "minimum_area_factor"), -1), (CHAIN, ("start",), []), (CHAIN, ("start", 0), [1, 2, 3]),
    (CHAIN, ("start", 0, 0), 1e71), (CHAIN, ("goal", "turns", 0), -180.5), (CHAIN, ("goal", "heading"), 3601),
    (CHAIN, ("bounds",), [[0, 0]]), (CHAIN, ("obstacles", 0), [[0, 0]]), (CHAIN, ("step",), 0),
    (CHAIN, ("tolerance",), -1), (SHAPES, ("body", "asv_count"), 0), (SHAPES, ("body", "asv_count"), 7.5),
    (SHAPES, ("body", "asv_count"), 100001), (SHAPES, ("goal", "bend"), 0), (SHAPES, ("goal", "bend"), 360),
    (SHAPES, ("goal", "leg"), 0), (SHAPES, ("goal", "shape"), "ring"), (SHAPES, ("start", "orientation"), "left"),
    (SHAPES, ("start",), {**SHAPES["start"], "bend": 90}), (ARC, ("goal", "leg"), 1),
    (ARC, ("unit",), ""), (ARC, ("unit",), "µ" * 17), (ARC, ("unit",), "m\n"), (ARM, ("body", "links"), []), (ARM, ("body", "links", 0), 0), (ARM, ("body", "angles"), "degrees"),
    (ARM, ("body", "joints"), []), (ARM, ("body", "joints", 0), "stop"), (ARM, ("start",), []),
    (POINT, ("map", "threshold"), 256), (POINT, ("map", "cell"), 0), (POINT, ("map", "file"), ""),
    (POINT, ("map", "unknown"), "free"), (POINT, ("map", "origin"), [0]), (POINT, ("map", "origin", 2), 1), (POINT, ("goal",), [1, 2, 3]),
    (POINT, ("limits", "speed"), 0), (POINT, ("limits", "speed"), 1e13), (POINT, ("limits", "acceleration"), []),
    (POINT, ("limits", "acceleration", 0), 1e-13)]


def of_another_type(value):
    """Two values of other types than this one. What may be null, a rectangle or "wrap" must not become that."""
    return [7, {"x": 1}] if not isinstance(value, (int, float, dict)) else ["x", True]


def changed(sample):
    """The sample with a member too many in each object, without each of its members, and with a value of
    another type in each place."""
    for at in places(sample):
        value = value_at(sample, at)
        if isinstance(value, dict):
            yield "a member more", with_value(sample, at, {**value, "surplus": 1})
        if at and isinstance(at[-1], str):
            yield f"no {at}", without(sample, at)
        for other in of_another_type(value):
            yield f"{other} at {at}", with_value(sample, at, other)


def is_read(scenario, folder):
    """Does a program take it for a scenario, whatever it then says of start and goal?"""
    file = folder / "s.json"
    file.write_text(json.dumps(scenario))
    return run("asv-validate", file, code=None).returncode != 3


def expect_same_verdict(what, scenario, folder):
    fault = fault_of(scenario, "scenario")
    read = is_read(scenario, folder)
    expect(read == (fault is None),
           f"{what}: the program {'reads' if read else 'refuses'} it, the schema says: {fault}\n  {scenario}")
    return read


def main():
    for file in sorted((root / "testcases").rglob("*.json")):
        fault = fault_of(json.loads(file.read_text()), "scenario")
        expect(fault is None, f"{file}: {fault}")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copy(root / "testcases" / "bodies" / "town.png", folder)
        refused = 0
        for name, sample in SAMPLES.items():
            expect(expect_same_verdict(name, sample, folder), f"{name}: refused")
            for what, scenario in changed(sample):
                refused += not expect_same_verdict(f"{name}, {what}", scenario, folder)
        expect(refused > 200, f"only {refused} changes were refused")
        for sample, at, value in OUT_OF_RANGE:
            expect(not expect_same_verdict(f"{value} at {at}", with_value(sample, at, value), folder),
                   f"{value} at {at}: taken")
    end()


main()
