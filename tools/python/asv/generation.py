"""Random problems of eight families."""

from __future__ import annotations

from typing import Any

from . import _core


def families() -> dict[str, list[str]]:
    """The families and the options of each: the long options of asv-generate, "_" for "-"."""
    return _core.families()


def generate(family: str, asv_count: int, seed: int = 1, *, attempts: int = 1,
             **options: Any) -> _core.Problem:
    """A random problem in the unit square. The same arguments give the same problem.

    family: a key of families(), whose options may be given as well. asv_count: 1, or 3 to 200.
    attempts: above 1: draws up to so many until vouch() says of one that it is solvable, else
    keeps the last. Lengths are in workspace units, of which a broom is 0.05 long.

    Raises ValueError that names the option for one out of range, TypeError for an unknown one,
    NoRoom when start or goal finds no place.
    """
    return _core.generate(family, asv_count, seed, attempts, options)


def vouch(problem: _core.Problem) -> tuple[bool, str]:
    """(True, reason) where a simple path is proven to exist, (False, reason) where that is
    unknown."""
    return _core.vouch(problem)
