"""Problems and scenarios: read, made, written."""

from __future__ import annotations

import json
import os
import warnings
from typing import Any, Mapping, Union

from . import _core
from .errors import FormatWarning, WriteError

PathLike = Union[str, "os.PathLike[str]"]


def _forgiving(read: tuple) -> Any:
    result, forgiven = read
    for file, line, message in forgiven:
        warnings.warn(f"{file}:{line}: {message}", FormatWarning, stacklevel=3)
    return result


def read_problem(file: PathLike, *, maps_anywhere: bool = False) -> _core.Problem:
    """Reads a problem file or a scenario (a file that begins with "{").

    What can be understood but is not as the format says is told as a FormatWarning.
    maps_anywhere: a scenario may name a map outside its own folder. Raises ParseError, with file,
    line and column, or ReadError.
    """
    return _forgiving(_core.read_problem(file, maps_anywhere))


def parse_problem(text: str, name: str = "<text>", folder: PathLike = ".", *,
                  maps_anywhere: bool = False) -> _core.Problem:
    """The same from text. name stands for the file in messages; the maps of a scenario are looked
    for in the folder."""
    return _forgiving(_core.parse_problem(text, name, folder, maps_anywhere))


def read_solution(file: PathLike, asv_count: int) -> _core.Solution:
    """Reads a solution file of so many ASVs; likewise."""
    return _forgiving(_core.read_solution(file, asv_count))


def parse_scenario(scenario: Mapping[str, Any], folder: PathLike = ".") -> _core.Problem:
    """A problem from the members of a scenario as a dict: chains with other brooms, arms, points,
    maps. docs/scenario.md lists the members; "version": 1 may be left out.

    >>> import asv
    >>> arm = asv.parse_scenario({
    ...     "body": {"kind": "arm", "base": [0.5, 0.1], "links": [0.2, 0.2], "angles": "relative",
    ...              "joints": "wrap"},
    ...     "start": [0.5, 0.5], "goal": [2.0, 0.5]})
    >>> arm.body, arm.asv_count
    ('arm', 3)

    Raises ParseError, whose text names the member.
    """
    return parse_problem(json.dumps({"version": 1, **scenario}), "<scenario>", folder)


def scenario(problem: _core.Problem) -> dict[str, Any]:
    """The problem as the members of a scenario: parse_scenario(scenario(p)) is p again. What came
    from a map is among the obstacles."""
    required = problem.requirements
    bounds = required.bounds
    members: dict[str, Any] = {
        "version": 1,
        "body": {"kind": problem.body},
        "start": problem.start.tolist(),
        "goal": problem.goal.tolist(),
        "bounds": None if bounds is None else [list(corner) for corner in bounds],
        "obstacles": problem.obstacles.tolist(),
        "step": required.max_step,
        "tolerance": required.tolerance,
    }
    arm = problem.arm
    if arm is not None:
        members["body"].update(
            base=problem.start[0].tolist(), links=list(arm.links), angles=arm.angles,
            joints=[joint if joint == "wrap" else list(joint) for joint in arm.joints])
        members["start"], members["goal"] = list(arm.start), list(arm.goal)
    elif problem.body == "chain":
        members["body"].update(broom_length=required.broom_length,
                               minimum_area_factor=required.area_radius_per_broom)
    else:
        members["start"], members["goal"] = members["start"][0], members["goal"][0]
    return members


def _is_classic(problem: _core.Problem) -> bool:
    usual, required = _core.Requirements(), problem.requirements
    names = ("broom_length", "max_step", "area_radius_per_broom", "bounds", "tolerance")
    return problem.body == "chain" and all(
        getattr(usual, name) == getattr(required, name) for name in names)


def write_problem(file: PathLike, problem: _core.Problem) -> None:
    """Writes a scenario where the file's name ends in ".json", else the classic format; either
    reads back to the same numbers.

    Raises ValueError for a problem that the classic format has no words for (an arm, a point,
    other requirements than the usual ones), WriteError where the file cannot be written.
    """
    if os.fspath(file).endswith(".json"):
        _write_text(file, json.dumps(scenario(problem), indent=1) + "\n")
    elif _is_classic(problem):
        _core.write_problem(file, problem)
    else:
        raise ValueError("only a scenario can hold this problem: name the file .json")


def _write_text(file: PathLike, text: str) -> None:
    try:
        with open(file, "w", encoding="utf-8") as out:
            out.write(text)
    except OSError as error:
        raise WriteError(f"{os.fspath(file)}: {error.strerror}") from error


def _pickled_problem(problem: _core.Problem) -> tuple:
    return parse_scenario, (scenario(problem),)


def _pickled_solution(solution: _core.Solution) -> tuple:
    return _core.Solution, (solution.path, solution.cost)
