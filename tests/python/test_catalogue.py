"""Planners and settings as data; problems to order."""

import os
import subprocess

import numpy
import pytest

import asv


def test_the_catalogue_is_the_program_s(capfd):
    names = asv.planner_names()
    assert names[0] == "auto" and [planner.name for planner in asv.planners()] == names
    program = os.environ.get("ASV_SOLVE")
    if program is None:
        pytest.skip("ASV_SOLVE names no program to compare with")
    listed = subprocess.run([program, "--list-planners"], capture_output=True, text=True,
                            check=True).stdout
    for planner in asv.planners():
        assert f"{planner.name}: {planner.summary} ({planner.source})" in listed
        for setting in planner.settings.values():
            assert f"    {setting.name} " in listed and setting.meaning in listed


def test_settings_have_types_defaults_and_reasons():
    for planner in asv.planners():
        for setting in planner.settings.values():
            assert setting.value == setting.default and setting.why and setting.source
            if setting.words:
                assert setting.value in setting.words
            elif not isinstance(setting.value, bool):
                assert setting.low <= setting.value <= setting.high


def test_settings_are_set_by_name():
    planner = asv.Planner("rrt-star", goal_bias=0.25, nodes=numpy.int64(50), sampler="uniform")
    planner["step"] = numpy.float64(0.125)
    assert (planner["goal-bias"], planner["goal_bias"], planner["nodes"]) == (0.25, 0.25, 50)
    assert planner["step"] == 0.125 and planner.settings["nodes"].default == 5000
    assert eval(repr(planner)).settings == planner.settings
    switch = asv.Planner("rrt-connect", ladder=False)
    assert switch["ladder"] is False


def test_what_cannot_be_set_is_told():
    with pytest.raises(ValueError, match="there are: auto"):
        asv.Planner("best")
    with pytest.raises(ValueError, match="rrt-connect has"):
        asv.Planner("auto", ladder=True)
    with pytest.raises(ValueError, match="from 0 to 1"):
        asv.Planner("rrt", goal_bias=2)
    with pytest.raises(TypeError):
        asv.Planner("rrt", goal_bias=None)
    with pytest.raises(KeyError):
        asv.Planner("rrt")["ladder"]


@pytest.mark.parametrize("family", asv.families())
def test_every_family_generates_valid_problems(family, tmp_path):
    problem = asv.generate(family, 3, seed=2)
    assert problem.asv_count == 3 and asv.invalid_ends(problem) == []
    assert asv.scenario(problem) == asv.scenario(asv.generate(family, 3, 2))
    program = os.environ.get("ASV_GENERATE")
    if program is not None:
        subprocess.run([program, family, "-n", "3", "--seed", "2", "-o", tmp_path / "theirs.txt"],
                       check=True)
        asv.write_problem(tmp_path / "ours.txt", problem)
        assert (tmp_path / "ours.txt").read_bytes() == (tmp_path / "theirs.txt").read_bytes()


def test_options_of_families():
    assert {"bends", "height", "orientation"} <= set(asv.families()["bend"])
    two, six = (asv.generate("gauntlet", 3, walls=walls, thickness=0.02) for walls in (2, 6))
    assert len(six.obstacles) > len(two.obstacles)
    asv.generate("crossing", 3, start_arm="east", goal_arm="west", orientation="cw", road=None)
    with pytest.raises(ValueError, match="there are: corridor"):
        asv.generate("desert", 3)
    with pytest.raises(TypeError, match="no option 'bend'"):
        asv.generate("bend", 3, bend=2)
    with pytest.raises(TypeError, match="bends"):
        asv.generate("bend", 3, bends="two")
    with pytest.raises(ValueError, match="expected one of random, inward"):
        asv.generate("spiral", 3, direction="up")
    with pytest.raises(ValueError, match="density"):
        asv.generate("clutter", 3, density=5.0)


def test_vouching():
    problem = asv.generate("corridor", 3, attempts=20)
    solvable, reason = asv.vouch(problem)
    assert solvable and reason
