"""Solving: options, results, progress, stops, threads."""

import os
import signal
import subprocess
import sys
import threading

import numpy
import pytest

import asv


def test_a_solution_leads_from_start_to_goal(past_a_box):
    result = asv.solve(past_a_box)
    assert result.solved and result.status == "solved" and result.reason == ""
    assert numpy.array_equal(result.path[0], past_a_box.start)
    assert numpy.array_equal(result.path[-1], past_a_box.goal)
    assert result.path.shape == (result.solution.steps + 1, 3, 2)
    assert result.lower_bound <= result.cost == result.statistics.cost
    assert asv.validate(past_a_box, result, continuous=True).valid
    assert repr(result).startswith("<asv.SolveResult: solved: cost ")


def test_the_arrays_outlive_the_result(past_a_box):
    path = asv.solve(past_a_box, optimize=0).path
    assert numpy.array_equal(path[0], past_a_box.start)


def test_the_same_seed_gives_the_bytes_of_the_program(testcases, tmp_path):
    program = os.environ.get("ASV_SOLVE")
    if program is None:
        pytest.skip("ASV_SOLVE names no program to compare with")
    file = testcases / "3ASV.txt"
    subprocess.run([program, file, tmp_path / "theirs.txt", "--threads", "1", "--seed", "7",
                    "--optimize", "0.1", "--planner", "rrt-connect", "--set", "ladder=off"],
                   check=True)
    planner = asv.Planner("rrt-connect", ladder=False)
    result = asv.solve(asv.read_problem(file), planner, seed=7, optimize=0.1)
    asv.write_solution(tmp_path / "ours.txt", result.solution)
    assert (tmp_path / "ours.txt").read_bytes() == (tmp_path / "theirs.txt").read_bytes()


@pytest.mark.parametrize("planner", asv.planner_names())
def test_every_planner_solves_a_point(planner):
    square = asv.Problem([(0.1, 0.5)], [(0.9, 0.5)], [(0.4, 0.2, 0.6, 0.9)], body="point")
    result = asv.solve(square, planner, optimize=0, keep_trees=True)
    assert result.solved and result.planner == planner
    tree = result.trees.trees[0]
    assert tree.points.shape == (len(tree.parents), 2) and tree.parents[0] == -1


def test_what_no_path_can_do_is_proven(testcases):
    for file in sorted((testcases / "infeasible").glob("*.txt")):
        result = asv.solve(asv.read_problem(file))
        assert result.status == "infeasible" and result.reason and not result.solved
        assert result.path is None and result.cost is None and result.solution is None
        assert result.lower_bound is None and result.reason in repr(result)


def test_invalid_ends_are_told(past_a_box):
    problem = asv.Problem(past_a_box.start, [(0.8, 0.5), (0.85, 0.5), (0.95, 0.5)])
    with pytest.raises(asv.InvalidEnds) as caught:
        asv.solve(problem)
    assert caught.value.ends == asv.invalid_ends(problem)
    assert {end for end, reason in caught.value.ends} == {"goal"}


@pytest.mark.parametrize("options", [
    {"time_limit": -1}, {"time_limit": float("nan")}, {"optimize": float("inf")},
    {"planner": "best"}])
def test_options_that_make_no_sense_are_value_errors(past_a_box, options):
    with pytest.raises(ValueError):
        asv.solve(past_a_box, **options)
    with pytest.raises(TypeError):
        asv.solve(past_a_box, seed=-1)


def test_all_options_at_once(past_a_box):
    result = asv.solve(past_a_box, "rrt-connect", seed=3, time_limit=30, optimize=0.05, threads=2,
                       reverse=True, keep_trees=True, max_iterations=100_000,
                       certify_motion=True, find_bounds=False)
    assert result.report.valid and result.report.motion
    assert result.lower_bound is None
    assert result.solved and {tree.root for tree in result.trees.trees} == {"start", "goal"}
    spent = result.statistics
    assert 0 < spent.time_to_first <= spent.time_total and spent.iterations >= 0
    assert spent.state_checks > 0 and sum(spent.tree_nodes) > 0
    assert spent.cost_history[-1][1] == pytest.approx(spent.cost, rel=1e-3)


def test_a_search_ends_after_so_many_iterations(testcases):
    problem = asv.read_problem(testcases / "7ASV.txt")
    result = asv.solve(problem, "rrt", max_iterations=5)
    assert result.status == "timeout" and result.report is None
    assert result.statistics.iterations == 5


def long_search(testcases):
    """Far more work than a test waits for."""
    return {"problem": asv.read_problem(testcases / "3ASV.txt"), "optimize": 300.0,
            "time_limit": 300.0}


def test_progress_is_told_in_the_calling_thread_and_errors_come_back(testcases):
    seen = []

    def on_progress(progress):
        seen.append((threading.get_ident(), progress.elapsed, progress.iterations))
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        asv.solve(on_progress=on_progress, **long_search(testcases))
    assert [thread for thread, _, _ in seen] == [threading.get_ident()]


def test_a_stop_keeps_the_best_path(testcases):
    costs = []
    result = asv.solve(on_progress=lambda progress: costs.append(progress.cost),
                       should_stop=lambda: len(costs) > 2 and costs[-1] is not None,
                       **long_search(testcases))
    assert result.solved and asv.validate(result.problem, result).valid


def test_another_thread_can_stop_it(testcases):
    stop = threading.Event()
    threading.Timer(0.3, stop.set).start()
    assert asv.solve(should_stop=stop.is_set, **long_search(testcases)).status in (
        "solved", "interrupted")


def test_ctrl_c_ends_it(testcases):
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        asv.solve(**long_search(testcases))


def test_other_python_threads_run_meanwhile(testcases):
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.wait(0.01):
            ticks.append(1)

    thread = threading.Thread(target=tick)
    thread.start()
    asv.solve(asv.read_problem(testcases / "3ASV.txt"), optimize=0.5, should_stop=lambda: len(
        ticks) > 3)
    stop.set()
    thread.join()
    assert len(ticks) > 3


def test_many_threads_solve_one_problem_at_once(past_a_box):
    expected = asv.solve(past_a_box, seed=5, optimize=0.02).path
    results = []

    def work():
        results.append(asv.solve(past_a_box, seed=5, optimize=0.02).path)

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 8 and all(numpy.array_equal(path, expected) for path in results)


SOLVE = """
import sys, asv
result = asv.solve(asv.read_problem(sys.argv[1]), optimize=0.1)
asv.write_solution(sys.argv[2], result.solution)
"""


def test_a_machine_without_avx_512_gets_the_same_bytes(testcases, tmp_path):
    texts = set()
    for name in ("", "AVX2", "SSE4", "SCALAR"):
        out = tmp_path / f"{name}.txt"
        run = subprocess.run([sys.executable, "-c", SOLVE, testcases / "7ASV.txt", out],
                             env=os.environ | {"ASV_SIMD": name}, capture_output=True, text=True)
        if f"no instruction set '{name}'" in run.stderr:
            continue
        assert run.returncode == 0, run.stderr
        texts.add(out.read_bytes())
    assert len(texts) == 1


def test_an_unknown_instruction_set_is_an_error_of_the_import():
    run = subprocess.run([sys.executable, "-c", "import asv"], capture_output=True, text=True,
                         env=os.environ | {"ASV_SIMD": "MMX"})
    assert run.returncode != 0 and "no instruction set 'MMX'" in run.stderr
