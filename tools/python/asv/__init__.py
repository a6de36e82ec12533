"""Plans how chains of ASVs (autonomous surface vehicles) that brooms join move among rectangles.

>>> import asv
>>> problem = asv.Problem(start=[(0.10, 0.50), (0.15, 0.50), (0.15, 0.55)],
...                       goal=[(0.80, 0.50), (0.85, 0.50), (0.85, 0.55)],
...                       obstacles=[(0.40, 0.30, 0.60, 0.80)])
>>> result = asv.solve(problem)
>>> result.path.shape  # states x ASVs x 2
(946, 3, 2)

Lengths are in workspace units, angles in radians, times in seconds. Everything is explained in
docs/python.md.
"""

from ._core import (Arm, CheckResult, Offender, Problem, Requirements, Rng, SearchTree, SearchTrees,
                    Solution, SolveProgress, SolveStatistics, ValidationReport, __version__, cost,
                    read_trees, write_solution, write_trees)
from .drawing import Picture, Player, draw, player, plot
from .errors import (FileError, FormatWarning, InvalidEnds, NoRoom, ParseError, ReadError,
                     WriteError)
from .generation import families, generate, vouch
from .catalogue import Planner, Setting, planner_names, planners
from .problems import (parse_problem, parse_scenario, read_problem, read_solution, scenario,
                       write_problem)
from .searching import SearchResult, Space, Tree, search
from .solving import SolveResult, invalid_ends, solve, validate, validate_state

__all__ = [
    "Arm", "CheckResult", "FileError", "FormatWarning", "InvalidEnds", "NoRoom", "Offender",
    "ParseError", "Picture", "Planner", "Player", "Problem", "ReadError", "Requirements", "Rng",
    "SearchResult", "SearchTree", "SearchTrees", "Setting", "Solution", "SolveProgress",
    "SolveResult", "SolveStatistics", "Space", "Tree", "ValidationReport", "WriteError",
    "__version__", "cost", "draw", "families", "generate", "invalid_ends", "parse_problem",
    "parse_scenario", "planner_names", "planners", "player", "plot", "read_problem",
    "read_solution", "read_trees", "scenario", "search", "solve", "validate", "validate_state",
    "vouch", "write_problem", "write_solution", "write_trees",
]
