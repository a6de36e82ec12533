"""The planners in a space of one's own, written in Python."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Optional, Protocol, Sequence, Union, runtime_checkable

from . import _core
from .catalogue import Planner, as_planner

if TYPE_CHECKING:
    import numpy


@runtime_checkable
class Space(Protocol):
    """What search() needs of a space. A configuration is a row of d numbers, handed over as an
    array of shape (d,).

    It may have besides, each derived from the others where it is lacking:

    - distance(a, b) -> float: in the metric; else Euclidean after the scales;
    - valid(a) -> bool; else motion_valid(a, a), within low and high where they are given;
    - cost(a, b) -> float: of a motion, symmetric; else the distance;
    - low, high: d numbers each, the bounds; needed by the roadmaps and by every sampler but "own",
      and where a step is 0;
    - scales: d numbers, what coordinates are multiplied by for nearest neighbours, which are looked
      for by Euclidean distance; else 1;
    - wrapping: (first, count), the coordinates that are angles and wrap at 2 pi; else none;
    - stride: how far RRT-Connect goes between two calls of motion_valid, in the metric; else a
      fiftieth of the longest side.
    """

    def sample(self, rng: _core.Rng) -> Optional[Sequence[float]]:
        """A valid configuration drawn from rng, or None where this try found none."""

    def motion_valid(self, a: "numpy.ndarray", b: "numpy.ndarray") -> bool:
        """Is the whole straight motion from a to b valid?"""


@dataclass(frozen=True)
class Tree:
    """A search tree; of a roadmap the nodes, all of which are roots."""

    rows: "numpy.ndarray"  #: nodes x d
    parents: "numpy.ndarray"  #: of each node; -1 for a root


@dataclass(frozen=True)
class SearchResult:
    """What a search found and what it spent."""

    outcome: str  #: "solved", or why it ended: "iterations", "nodes", "deadline"
    path: Optional["numpy.ndarray"]  #: states x d from start to goal; None unless solved
    cost: Optional[float]  #: of the path
    trees: list[Tree]  #: that of the start, that of the goal; or one alone
    edges: list[tuple[int, int]]  #: of a roadmap: pairs of nodes
    iterations: int

    @property
    def solved(self) -> bool:
        """Is there a path?"""
        return self.path is not None


def search(space: Space, start: Sequence[float], goal: Sequence[float],
           planner: Union[str, Planner] = "rrt", *, seed: int = 1, max_iterations: int = 100_000,
           max_nodes: Optional[int] = None, time_limit: Optional[float] = None,
           on_progress: Optional[Callable[[int, Sequence[int], Optional[float]], object]] = None
           ) -> SearchResult:
    """Runs a planner of the library ("rrt", "rrt-connect", "rrt-star", "prm-random", ...) in a
    space that is written in Python, see Space.

    start, goal: d numbers each, both valid. time_limit: seconds; None: no limit. on_progress(
    iterations, [nodes, nodes of the second tree], cost or None): called in each iteration. The
    same arguments give the same result. Only the space judges motions: they are as proven as it
    makes them.

    Raises ValueError for an end that is not valid or a planner that does not suit; what the space
    raises is raised.
    """
    found = _core.search(space, start, goal, as_planner(planner)._choice, seed=seed,
                         max_iterations=max_iterations, max_nodes=max_nodes,
                         time_limit=time_limit, on_progress=on_progress)
    found["trees"] = [Tree(*tree) for tree in found["trees"]]
    found["edges"] = [tuple(edge) for edge in found["edges"]]
    return SearchResult(**found)
