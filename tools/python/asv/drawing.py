"""Pictures, the player, and axes of matplotlib."""

from __future__ import annotations

import html
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _core
from .errors import WriteError

if TYPE_CHECKING:
    from .solving import SolveResult

PathLike = Union[str, "os.PathLike[str]"]


def _write_bytes(file: PathLike, content: bytes) -> None:
    try:
        Path(file).write_bytes(content)
    except OSError as error:
        raise WriteError(f"{os.fspath(file)}: {error.strerror}") from error


class Picture:
    """A drawing of a problem and its solution; a notebook shows it."""

    def __init__(self, exhibit: _core.Exhibit, theme: str) -> None:
        self._exhibit = exhibit
        self._theme = theme

    @property
    def svg(self) -> str:
        """The text of the SVG."""
        return _core.draw(self._exhibit, "svg", self._theme).decode()

    @property
    def png(self) -> bytes:
        """The bytes of a PNG with two pixels for each point."""
        return _core.draw(self._exhibit, "png", self._theme)

    @property
    def pdf(self) -> bytes:
        """The bytes of a PDF."""
        return _core.draw(self._exhibit, "pdf", self._theme)

    def save(self, file: PathLike) -> None:
        """Writes the picture in the format of the file's ending: .svg, .png or .pdf."""
        kind = Path(file).suffix[1:]
        _write_bytes(file, _core.draw(self._exhibit, kind, self._theme))

    def _repr_svg_(self) -> str:
        return self.svg


class Player:
    """A page that plays a motion; it needs nothing but a browser. A notebook shows it in its
    cell."""

    #: of the frame in a notebook, in pixels
    height = 760

    def __init__(self, exhibit: _core.Exhibit) -> None:
        #: the text of the page
        self.html: str = _core.player(exhibit)

    def save(self, file: PathLike) -> None:
        """Writes the page."""
        _write_bytes(file, self.html.encode())

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" title="Player" '
                f'style="width: 100%; height: {self.height}px; border: 0"></iframe>')


def draw(problem: _core.Problem, solution: Optional[_core.Solution] = None, *,
         trees: Optional[_core.SearchTrees] = None, lower_bound: Optional[float] = None,
         title: str = "", planner: str = "", theme: str = "light") -> Picture:
    """The picture that asv-view draws. lower_bound: of the cost, shown beside it; planner: shown
    when not empty; theme: "light" or "dark"."""
    exhibit = _core.exhibit(problem, solution, trees, lower_bound, title, planner)
    return Picture(exhibit, theme)


def player(problem: _core.Problem, solution: Optional[_core.Solution] = None, *,
           trees: Optional[_core.SearchTrees] = None, lower_bound: Optional[float] = None,
           title: str = "", planner: str = "") -> Player:
    """The player of asv-view. Without a solution it shows start and goal."""
    return Player(_core.exhibit(problem, solution, trees, lower_bound, title, planner))


def plot(problem: _core.Problem, solution: Union[_core.Solution, "SolveResult", None] = None,
         axes: Any = None, *, chains: int = 12) -> Any:
    """Draws on axes of matplotlib, new ones by default, and returns them: obstacles, start, goal,
    the way of each ASV, and the body at so many states. Raises ImportError without matplotlib."""
    from matplotlib import pyplot
    from matplotlib.collections import LineCollection, PatchCollection
    from matplotlib.patches import Rectangle

    if axes is None:
        axes = pyplot.subplots()[1]
    boxes = [Rectangle(low, *(high - low)) for low, high in problem.obstacles]
    axes.add_collection(PatchCollection(boxes, facecolor="#808d9a"))
    path = None if solution is None else solution.path
    if path is not None:
        shown = path[:: max(1, (len(path) - 1) // max(1, chains))]
        axes.add_collection(LineCollection(list(path.transpose(1, 0, 2)), colors="#4a5a69",
                                           linewidths=0.6, alpha=0.7))
        axes.add_collection(LineCollection(list(shown), colors="#4a5a69", linewidths=1))
    for state, colour, label in ((problem.start, "#0068a8", "start"),
                                 (problem.goal, "#007d57", "goal")):
        axes.plot(state[:, 0], state[:, 1], "o-", color=colour, markersize=4, label=label)
    bounds = problem.requirements.bounds
    if bounds is not None:
        axes.set_xlim(bounds[0][0], bounds[1][0])
        axes.set_ylim(bounds[0][1], bounds[1][1])
    axes.set_aspect("equal")
    return axes
