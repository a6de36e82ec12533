"""The report of the validator."""

import numpy
import pytest

import asv


@pytest.fixture
def spoilt(past_a_box):
    """A path of which one state has left the plane, and its number."""
    path = asv.solve(past_a_box, optimize=0).path.copy()
    path[100] += 0.9
    return asv.Solution(path), 100


def test_a_good_path_passes_every_check(past_a_box):
    result = asv.solve(past_a_box, optimize=0)
    report = asv.validate(past_a_box, result, continuous=True)
    assert report.valid and report.cost == pytest.approx(result.cost)
    assert [check.name for check in report.checks] == [
        "ends", "steps", "cost", "broom lengths", "convexity", "area", "bounds", "collisions"]
    assert all(check.ok and check.failures == 0 for check in report.checks + report.motion)
    collisions = report.checks[-1]
    assert collisions.states == len(result.path) and collisions.worst.obstacle == 0
    assert collisions.worst.room > 0 and "room" in collisions.describe()
    assert str(report).splitlines()[0] == "valid"


def test_a_bad_path_is_told_where_it_is_bad(past_a_box, spoilt):
    solution, bad = spoilt
    report = asv.validate(past_a_box, solution, list_offenders=True)
    failed = {check.name: check for check in report.checks if not check.ok}
    assert not report.valid and set(failed) == {"steps", "bounds"}
    assert [offender.state for offender in failed["bounds"].offenders] == [bad]
    assert failed["bounds"].worst.room < 0 and failed["bounds"].worst.asv in (0, 1, 2)
    assert failed["steps"].failures == 2 and "FAILS steps" in str(report)


def test_the_tolerance_counts(past_a_box, spoilt):
    assert asv.validate(past_a_box, spoilt[0], tolerance=10).valid
    with pytest.raises(ValueError):
        asv.validate(past_a_box, spoilt[0], tolerance=-1)


def test_one_state_alone(past_a_box):
    assert asv.validate_state(past_a_box, past_a_box.start).valid
    assert not asv.validate_state(past_a_box, past_a_box.start + 2).valid
    with pytest.raises(ValueError, match="number of ASVs"):
        asv.validate_state(past_a_box, past_a_box.start[:2])


def test_what_cannot_be_validated_is_a_value_error(past_a_box, testcases):
    with pytest.raises(ValueError):
        asv.validate(past_a_box, asv.Solution(numpy.zeros((3, 2, 2))))
    with pytest.raises(ValueError):
        asv.validate(past_a_box, asv.Solution(numpy.zeros((0, 3, 2))))
    none = asv.solve(asv.read_problem(testcases / "infeasible" / "two-asvs.txt"))
    with pytest.raises(ValueError, match="no solution"):
        asv.validate(none.problem, none)
