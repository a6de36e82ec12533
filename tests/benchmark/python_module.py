#!/usr/bin/env python3
"""What Python adds to the library: python_module.py [PROBLEM]

- overhead: the wall clock of asv.solve beside what the library's own clock says of the same call;
- arrays: a path of 100,000 states of 7 ASVs as an array;
- threads: two solves in two threads beside the same two one after the other.
Run it with PYTHONPATH=build/release/python and nothing else running.
"""

import statistics
import sys
import threading
import time

import numpy

import asv


def timed(work):
    """Seconds that it takes."""
    before = time.perf_counter()
    work()
    return time.perf_counter() - before


def overhead(problem, optimize, seeds, repeats=5):
    """Medians over seeds: the share that Python adds to the library's own time, and that time. Of
    each seed the run with the least surplus counts: the others waited for the processor."""
    shares, library = [], []
    for seed in range(1, seeds + 1):
        runs = []
        for _ in range(repeats):
            before = time.perf_counter()
            result = asv.solve(problem, seed=seed, optimize=optimize)
            path = result.path
            surplus = time.perf_counter() - before - result.statistics.time_total
            assert path is not None
            runs.append((surplus, result.statistics.time_total))
        surplus, inside = min(runs)
        shares.append(surplus / inside)
        library.append(inside)
    return statistics.median(shares), statistics.median(library)


def main():
    file = sys.argv[1] if len(sys.argv) > 1 else "testcases/7ASV.txt"
    problem = asv.read_problem(file)
    asv.solve(problem, optimize=0)
    for optimize, seeds in ((0, 30), (0.3, 5)):
        share, library = overhead(problem, optimize, seeds)
        print(f"solve, optimize={optimize}: {1000 * library:.1f} ms in the library, "
              f"{100 * share:.2f} % more from Python (median of {seeds} seeds)")

    solution = asv.Solution(numpy.zeros((100_000, 7, 2)))
    solution.path.copy()  # so that memory is not counted that comes for the first time
    print(f"path of 100,000 states: {1e6 * timed(lambda: solution.path):.1f} us as a view, "
          f"{1000 * timed(lambda: solution.path.copy()):.2f} ms as a copy")

    def two(parallel):
        threads = [threading.Thread(target=asv.solve, args=(problem,), kwargs={"seed": seed})
                   for seed in (1, 2)]
        for thread in threads:
            thread.start()
            if not parallel:
                thread.join()
        for thread in threads:
            thread.join()

    one_by_one, at_once = timed(lambda: two(False)), timed(lambda: two(True))
    print(f"two solves: {one_by_one:.2f} s one after the other, {at_once:.2f} s in two threads, "
          f"ratio {at_once / one_by_one:.2f}")


if __name__ == "__main__":
    main()
