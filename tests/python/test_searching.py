"""The planners in a space that is written in Python."""

import math
import threading
import os
import signal

import numpy
import pytest

import asv


class Walls:
    """A point in the unit square; two walls leave a door each."""

    low, high = (0.0, 0.0), (1.0, 1.0)
    walls = [(0.3, 0.0, 0.35, 0.8), (0.6, 0.2, 0.65, 1.0)]

    def sample(self, rng):
        point = (rng.uniform(), rng.uniform())
        return point if self.motion_valid(point, point) else None

    def distance(self, a, b):
        return math.hypot(a[0] - b[0], a[1] - b[1])

    def motion_valid(self, a, b):
        return not any(self.meets(a, b, wall) for wall in self.walls)

    @staticmethod
    def meets(a, b, wall):
        """Does the segment meet the box? By clipping it to each pair of sides."""
        enter, leave = 0.0, 1.0
        for i in (0, 1):
            low, high, way = wall[i] - a[i], wall[i + 2] - a[i], b[i] - a[i]
            if way == 0:
                if low > 0 or high < 0:
                    return False
                continue
            first, last = sorted((low / way, high / way))
            enter, leave = max(enter, first), min(leave, last)
        return enter <= leave


START, GOAL = (0.1, 0.1), (0.9, 0.9)
PLANNERS = [name for name in asv.planner_names() if name != "auto"]


@pytest.mark.parametrize("planner", PLANNERS)
def test_every_planner_finds_its_way(planner):
    options = {"nodes": 400} if planner == "rrt-star" else {}
    if planner.startswith("prm"):
        options = {"samples": 150}
    found = asv.search(Walls(), START, GOAL, asv.Planner(planner, **options), seed=3)
    assert found.solved and found.outcome == "solved" and found.iterations > 0
    assert tuple(found.path[0]) == START and tuple(found.path[-1]) == GOAL
    space = Walls()
    steps = list(zip(found.path, found.path[1:]))
    assert all(space.motion_valid(a, b) for a, b in steps)
    assert found.cost == pytest.approx(sum(space.distance(a, b) for a, b in steps))
    tree = found.trees[0]
    assert tree.rows.shape == (len(tree.parents), 2)
    again = asv.search(Walls(), START, GOAL, asv.Planner(planner, **options), seed=3)
    assert numpy.array_equal(again.path, found.path)


def test_roadmaps_have_edges_and_may_take_the_space_s_own_samples():
    planner = asv.Planner("prm-random", samples=100, sampler="own")
    found = asv.search(Walls(), START, GOAL, planner)
    rows, edges = found.trees[0].rows, numpy.array(found.edges)
    assert edges.shape[1] == 2 and edges.max() < len(rows) and (found.trees[0].parents == -1).all()


def test_rrt_star_gets_better():
    costs = []
    asv.search(Walls(), START, GOAL, asv.Planner("rrt-star", nodes=600), seed=1,
               on_progress=lambda iterations, nodes, cost: costs.append(cost))
    known = [cost for cost in costs if cost is not None]
    assert costs[0] is None and known[-1] < known[0]
    assert all(b <= a + 1e-9 for a, b in zip(known, known[1:]))


class Dial:
    """An angle that must not pass a stop at half a turn, the short way round."""

    low, high, wrapping, scales = (0.0,), (2 * math.pi,), (0, 1), (1.0,)
    stop = 3.0

    def sample(self, rng):
        return [rng.uniform(0, 2 * math.pi)]

    def motion_valid(self, a, b):
        return not any(min(a[0], b[0]) <= self.stop + turn <= max(a[0], b[0])
                       for turn in (-2 * math.pi, 0, 2 * math.pi))


@pytest.mark.parametrize("planner", ["rrt", "rrt-connect", "rrt-star", "prm-random"])
def test_angles_wrap(planner):
    planner = asv.Planner(planner, **({"nodes": 50} if planner == "rrt-star" else {}))
    found = asv.search(Dial(), [2.5], [3.5], planner, max_iterations=2000)
    assert found.solved and abs(abs(found.path[-1, 0] - found.path[0, 0]) - (2 * math.pi - 1)) < 1e-9


def test_limits_end_a_search():
    class Closed(Walls):
        walls = [(0.3, -1.0, 0.35, 2.0)]

    assert asv.search(Closed(), START, GOAL, max_iterations=50).outcome == "iterations"
    assert asv.search(Closed(), START, GOAL, max_nodes=20).outcome == "nodes"
    late = asv.search(Closed(), START, GOAL, time_limit=0.05)
    assert late.outcome == "deadline" and late.path is None and late.cost is None


def test_ctrl_c_ends_a_search():
    class Closed(Walls):
        walls = [(0.3, -1.0, 0.35, 2.0)]

    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        asv.search(Closed(), START, GOAL, max_iterations=10**9)


def test_what_the_space_raises_is_raised():
    class Broken(Walls):
        def sample(self, rng):
            raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        asv.search(Broken(), START, GOAL)


@pytest.mark.parametrize("changes, error, words", [
    ({"sample": None}, TypeError, "NoneType"),
    ({"sample": lambda rng: (1, 2, 3)}, ValueError, "returned 3 numbers"),
    ({"low": (0,)}, ValueError, "low has 1"),
    ({"high": None}, ValueError, "both low and high"),
    ({"wrapping": (1, 2)}, ValueError, "wrapping"),
])
def test_spaces_that_make_no_sense(changes, error, words):
    space = Walls()
    for name, value in changes.items():
        setattr(space, name, value)
    with pytest.raises(error, match=words):
        asv.search(space, START, GOAL, seed=2)


def test_calls_that_make_no_sense():
    with pytest.raises(ValueError, match="the start is not valid"):
        asv.search(Walls(), (0.32, 0.5), GOAL)
    with pytest.raises(ValueError, match="same number"):
        asv.search(Walls(), START, (1,))
    with pytest.raises(ValueError, match="choose another"):
        asv.search(Walls(), START, GOAL, "auto")
    with pytest.raises(TypeError, match="sample"):
        asv.search(object(), START, GOAL)
    assert isinstance(Walls(), asv.Space) and not isinstance(object(), asv.Space)


def test_random_numbers_are_the_library_s():
    rng, same = asv.Rng(7), asv.Rng(7)
    assert [rng.uniform() for _ in range(9)] == [same.uniform() for _ in range(9)]
    assert 2 <= rng.uniform(2, 3) < 3 and rng.below(4) in range(4)
    assert rng.chance(1) and not rng.chance(0) and math.isfinite(rng.normal())
    with pytest.raises(ValueError):
        rng.below(0)
