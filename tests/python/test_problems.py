"""Problems, scenarios and solutions: made, read, written, refused."""

import pickle

import numpy
import pytest

import asv


def assert_same(one, other):
    assert asv.scenario(one) == asv.scenario(other)


def test_a_problem_has_the_arrays_that_it_was_made_of(past_a_box):
    assert past_a_box.start.shape == (3, 2)
    assert past_a_box.goal.tolist()[0] == [0.80, 0.50]
    assert past_a_box.obstacles.tolist() == [[[0.40, 0.30], [0.60, 0.80]]]
    assert past_a_box.asv_count == 3 and past_a_box.body == "chain" and past_a_box.arm is None


def test_arrays_are_read_only_views_that_keep_the_problem_alive(past_a_box):
    start = past_a_box.start
    assert not start.flags.owndata
    with pytest.raises(ValueError):
        start[0, 0] = 1
    obstacles = asv.Problem([(0, 0)], [(1, 1)], numpy.arange(4.0).reshape(1, 4)).obstacles
    assert obstacles.tolist() == [[[0, 1], [2, 3]]]


@pytest.mark.parametrize("changes, words", [
    ({"start": [(0, 0, 0)]}, "n x 2"),
    ({"start": [(0, float("nan"))]}, "finite"),
    ({"start": [(0, 0)]}, "same number"),
    ({"obstacles": [(0, 0, 1)]}, "m x 4"),
    ({"obstacles": [(1, 0, 0, 1)]}, "high corner below"),
    ({"body": "fish"}, "chain"),
    ({"body": "point"}, "one point"),
])
def test_what_makes_no_sense_is_a_value_error(past_a_box, changes, words):
    given = {"start": past_a_box.start, "goal": past_a_box.goal, **changes}
    with pytest.raises(ValueError, match=words):
        asv.Problem(**given)


def test_requirements_are_checked_and_kept():
    wide = asv.Requirements(broom_length=2, max_step=0.1, bounds=None)
    problem = asv.Problem([(0, 0), (2, 0), (2, 2)], [(9, 0), (11, 0), (11, 2)], requirements=wide)
    assert problem.requirements.bounds is None and problem.requirements.broom_length == 2
    assert asv.Requirements().bounds == ((0, 0), (1, 1))
    with pytest.raises(ValueError):
        asv.Requirements(broom_length=0)
    with pytest.raises(ValueError, match="bounds"):
        asv.Requirements(bounds=((1, 1), (0, 0)))


def test_every_test_case_survives_writing_and_reading(testcases, tmp_path):
    for file in sorted(testcases.glob("*.txt")):
        problem = asv.read_problem(file)
        for name in ("problem.txt", "problem.json"):
            asv.write_problem(tmp_path / name, problem)
            assert_same(asv.read_problem(tmp_path / name), problem)


def test_every_scenario_survives_writing_and_reading(testcases, tmp_path):
    for file in sorted((testcases / "bodies").glob("*.json")):
        problem = asv.read_problem(file)
        asv.write_problem(tmp_path / "problem.json", problem)
        assert_same(asv.read_problem(tmp_path / "problem.json"), problem)
        with pytest.raises(ValueError, match=".json"):
            asv.write_problem(tmp_path / "problem.txt", problem)


def test_an_arm_is_made_from_a_scenario():
    arm = asv.parse_scenario({
        "body": {"kind": "arm", "base": [0.5, 0.1], "links": [0.2, 0.1], "angles": "relative",
                 "joints": ["wrap", [-1, 1]]},
        "start": [0.5, 0.5], "goal": [2.0, 0.5]})
    assert arm.arm.links == [0.2, 0.1] and arm.arm.joints == ["wrap", (-1, 1)]
    assert arm.start.shape == (3, 2) and arm.start.tolist()[0] == [0.5, 0.1]


def test_problems_and_solutions_can_be_pickled(past_a_box, testcases):
    arm = asv.read_problem(testcases / "bodies" / "arm-3-plane.json")
    for problem in (past_a_box, arm):
        assert_same(pickle.loads(pickle.dumps(problem)), problem)
    solution = asv.Solution(numpy.zeros((4, 3, 2)), 1.5)
    again = pickle.loads(pickle.dumps(solution))
    assert again.cost == 1.5 and again.path.shape == (4, 3, 2)


def test_a_parse_error_carries_its_place(testcases):
    with pytest.raises(asv.ParseError) as caught:
        asv.parse_problem("3\n0 0 1 x\n", name="mine.txt")
    error = caught.value
    assert (error.file, error.line, error.column, error.found) == ("mine.txt", 2, 7, "'x'")
    assert str(error).startswith("mine.txt:2:7: expected ") and isinstance(error, ValueError)
    assert str(pickle.loads(pickle.dumps(error))) == str(error)


def test_every_invalid_file_is_refused_with_its_name(testcases):
    for file in sorted((testcases / "invalid").glob("*.txt")):
        try:
            problem = asv.read_problem(file)
        except asv.ParseError as error:
            assert error.file == str(file) and error.line >= 1
        else:
            assert asv.invalid_ends(problem)
            with pytest.raises(asv.InvalidEnds):
                asv.solve(problem)


def test_files_that_cannot_be_read_or_written(tmp_path, past_a_box):
    with pytest.raises(asv.ReadError):
        asv.read_problem(tmp_path / "none.txt")
    for name in ("none/problem.txt", "none/problem.json"):
        with pytest.raises(asv.WriteError):
            asv.write_problem(tmp_path / name, past_a_box)
    assert issubclass(asv.ReadError, asv.FileError) and issubclass(asv.FileError, OSError)


def test_what_had_to_be_forgiven_is_a_warning():
    text = "1\n0.1 0.1\n0.2 0.2 0.3 0.3\n0\n"
    with pytest.warns(asv.FormatWarning, match="mine.txt:3"):
        asv.parse_problem(text, name="mine.txt")


def test_solutions_survive_writing_and_reading(tmp_path):
    path = numpy.random.default_rng(1).random((50, 3, 2))
    solution = asv.Solution(path)
    asv.write_solution(tmp_path / "s.txt", solution)
    again = asv.read_solution(tmp_path / "s.txt", 3)
    assert numpy.array_equal(again.path, path) and again.cost == solution.cost
    assert solution.steps == 49
    moved = numpy.linalg.norm(numpy.diff(path, axis=0), axis=2).sum()
    assert solution.cost == pytest.approx(moved)


def test_a_path_is_a_view_of_100000_states():
    solution = asv.Solution(numpy.zeros((100_000, 7, 2)))
    path = solution.path
    assert path.shape == (100_000, 7, 2) and not path.flags.owndata and not path.flags.writeable
    assert numpy.shares_memory(path, solution.path)
    del solution
    assert path[-1].sum() == 0
    with pytest.raises(ValueError, match="states x ASVs x 2"):
        asv.Solution(numpy.zeros((4, 2)))


def test_the_cost_of_an_arm_is_that_of_its_joints(testcases):
    arm = asv.read_problem(testcases / "bodies" / "arm-3-plane.json")
    result = asv.solve(arm, optimize=0)
    assert asv.cost(arm, result.path) == pytest.approx(result.cost)
