"""What is taken is given back, and threads solve side by side."""

import gc
import os
import sys
import threading

import pytest

import asv

PAGE = os.sysconf("SC_PAGE_SIZE")


def resident_bytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * PAGE


def one_round(problem, number):
    """One solve, and by turns what else a session does with problems and results."""
    result = asv.solve(problem, seed=number, optimize=0, keep_trees=number % 3 == 0)
    assert result.path.shape[1:] == (1, 2)
    if number % 50 == 0:
        asv.validate(problem, result)
        result.draw().svg
        with pytest.raises(asv.InvalidEnds):
            asv.solve(asv.Problem([(2, 2)], [(0, 0)], body="point"))
        with pytest.raises(asv.ParseError):
            asv.parse_problem("nonsense")


@pytest.mark.skipif("ASV_SANITIZED" in os.environ, reason="the sanitizer keeps what is freed")
def test_ten_thousand_solves_leak_nothing():
    problem = asv.Problem([(0.50, 0.50)], [(0.51, 0.52)], [(0.2, 0.2, 0.4, 0.3)], body="point")
    for number in range(2_000):
        one_round(problem, number)
    gc.collect()
    memory, blocks = resident_bytes(), sys.getallocatedblocks()
    for number in range(10_000):
        one_round(problem, number)
    gc.collect()
    grown, new_blocks = resident_bytes() - memory, sys.getallocatedblocks() - blocks
    print(f"after 10,000 solves: {grown} bytes more, {new_blocks} blocks of Python more")
    assert grown < 1_000_000 and new_blocks < 1_000


def test_two_threads_solve_at_the_same_time(testcases):
    """Each solve goes on until the other one runs as well, so both ends prove that both ran."""
    problem = asv.read_problem(testcases / "3ASV.txt")
    running = [threading.Event(), threading.Event()]
    statuses = [None, None]

    def work(own):
        def should_stop():
            running[own].set()
            return running[1 - own].is_set()

        statuses[own] = asv.solve(problem, optimize=300, time_limit=300,
                                  should_stop=should_stop).status

    threads = [threading.Thread(target=work, args=(own,)) for own in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert set(statuses) <= {"solved", "interrupted"}
