"""Solving and validating."""

from __future__ import annotations

from typing import TYPE_CHECKING, Callable, Optional, Union

from . import _core
from .catalogue import Planner, as_planner

if TYPE_CHECKING:
    import numpy

    from .drawing import Picture, Player


class SolveResult:
    """What solve() came to. In a notebook it shows its picture.

    Attributes: problem; planner, its name.
    """

    def __init__(self, problem: _core.Problem, planner: str, outcome: _core.SolveOutcome) -> None:
        self.problem = problem
        self.planner = planner
        self._outcome = outcome

    @property
    def status(self) -> str:
        """"solved", "timeout", "infeasible" (proven) or "interrupted"."""
        return self._outcome.status

    @property
    def solved(self) -> bool:
        """Is there a solution?"""
        return self._outcome.status == "solved"

    @property
    def reason(self) -> str:
        """Why there is no solution; empty when solved."""
        return self._outcome.reason

    @property
    def solution(self) -> Optional[_core.Solution]:
        """The solution, which has passed the validator; None where there is none."""
        return self._outcome.solution

    @property
    def path(self) -> Optional["numpy.ndarray"]:
        """Array states x ASVs x 2, workspace units, a read-only view; None without a solution."""
        solution = self.solution
        return None if solution is None else solution.path

    @property
    def cost(self) -> Optional[float]:
        """Distance that all ASVs move, workspace units (an arm: radians); None without a
        solution."""
        solution = self.solution
        return None if solution is None else solution.cost

    @property
    def lower_bound(self) -> Optional[float]:
        """No path costs less; None where there was no time to find out."""
        return self.statistics.cost_lower_bound or None

    @property
    def report(self) -> Optional[_core.ValidationReport]:
        """The validator's, of the solution, the motion between the states where that was to be
        certified; None without a solution."""
        return self._outcome.report if self.solved else None

    @property
    def statistics(self) -> _core.SolveStatistics:
        """Times in seconds, costs, nodes, checks."""
        return self._outcome.statistics

    @property
    def trees(self) -> _core.SearchTrees:
        """What the planner has explored; without trees unless solve() was asked to keep them."""
        return self._outcome.trees(self.planner, self.problem.asv_count)

    def draw(self, title: str = "", theme: str = "light") -> "Picture":
        """The picture of problem and solution, with the trees where they were kept."""
        from .drawing import draw
        trees = self.trees
        return draw(self.problem, self.solution, trees=trees if trees.trees else None,
                    lower_bound=self.lower_bound, planner=self.planner, title=title, theme=theme)

    def player(self, title: str = "") -> "Player":
        """The player, which plays the motion in a notebook cell or a browser."""
        from .drawing import player
        trees = self.trees
        return player(self.problem, self.solution, trees=trees if trees.trees else None,
                      lower_bound=self.lower_bound, planner=self.planner, title=title)

    def _repr_svg_(self) -> str:
        return self.draw().svg

    def __repr__(self) -> str:
        if not self.solved:
            return f"<asv.SolveResult: {self.status}: {self.reason}>"
        bound = self.lower_bound
        ratio = f", at most {self.cost / bound:.4g} times the least possible" if bound else ""
        return (f"<asv.SolveResult: solved: cost {self.cost:.4g}{ratio}, "
                f"{self.solution.steps} steps>")


def solve(problem: _core.Problem, planner: Union[str, Planner] = "auto", *, seed: int = 1,
          time_limit: float = 60.0, max_iterations: Optional[int] = None, optimize: float = 1.0,
          threads: int = 1, reverse: bool = False, keep_trees: bool = False,
          certify_motion: bool = False, find_bounds: bool = True,
          on_progress: Optional[Callable[[_core.SolveProgress], object]] = None,
          should_stop: Optional[Callable[[], bool]] = None) -> SolveResult:
    """Plans, improves and checks.

    planner: a name or a Planner. seed: with one thread and enough time the same seed gives the
    same path. time_limit: seconds of wall clock for everything. max_iterations: of each thread's
    search, no limit if None. optimize: improvement after the first path, in seconds of work of a
    2.8 GHz core, counted, not timed. threads: that race and improve. reverse: plan from the goal
    to the start. keep_trees: fill SolveResult.trees. certify_motion: let the validator check the
    motion between the states too, see SolveResult.report. find_bounds: fill
    SolveResult.lower_bound.

    on_progress: called some ten times a second, in the calling thread. should_stop: asked some
    fifty times a second, for example threading.Event().is_set; True ends the work early, and the
    best path so far is kept. Ctrl-C and what either function raises end the work and are raised.
    Other Python threads run meanwhile, and may solve as well.

    Raises InvalidEnds when start or goal is not valid, ValueError when an option makes no sense.
    """
    chosen = as_planner(planner)
    outcome = _core.solve(
        problem, chosen._choice, seed=seed, time_limit=time_limit, max_iterations=max_iterations,
        optimize=optimize, threads=threads, reverse=reverse, keep_trees=keep_trees,
        certify_motion=certify_motion, find_bounds=find_bounds, on_progress=on_progress,
        should_stop=should_stop)
    return SolveResult(problem, chosen.name, outcome)


def validate(problem: _core.Problem, solution: Union[_core.Solution, SolveResult], *,
             tolerance: float = 1e-5, continuous: bool = False,
             list_offenders: bool = False) -> _core.ValidationReport:
    """Checks every requirement with exact predicates and without any code of the planners.

    tolerance: how lenient, in the unit of each requirement. continuous: also the motion between
    the states. list_offenders: fill CheckResult.offenders. print() shows the report.

    Raises ValueError for another number of ASVs than the problem has, or no state.
    """
    if isinstance(solution, SolveResult):
        if solution.solution is None:
            raise ValueError(f"there is no solution to validate: {solution.reason}")
        solution = solution.solution
    return _core.validate(problem, solution, tolerance=tolerance, continuous=continuous,
                          list_offenders=list_offenders)


def validate_state(problem: _core.Problem, state: "numpy.ndarray", *,
                   tolerance: float = 1e-5) -> _core.ValidationReport:
    """Checks one state, an array ASVs x 2: what is left without ends, steps and cost."""
    return _core.validate_state(problem, state, tolerance=tolerance)


def invalid_ends(problem: _core.Problem) -> list[tuple[str, str]]:
    """("start" or "goal", reason) for each end that violates a requirement."""
    return _core.invalid_ends(problem)
