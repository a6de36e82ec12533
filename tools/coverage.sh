#!/usr/bin/env bash
# How much of core, geometry, io and tools the tests run, as gcov counts it: builds them without optimisation
# (preset coverage), runs the tests, prints lines and branches by room, and ends with 1 where a gate is missed.
# coverage.sh validation looks at core/validation alone, in a few minutes: the gate of what judges paths, by its
# own tests. tools/coverage/table.py tells what a branch is; `tools/coverage/table.py build/coverage
# core/search --missing` then tells which of a room were never taken.
# Not run, so not counted: pages and shells (browser, docs, site, manual), Python, OMPL and MPI; signals and time
# limits, which so slow a build does not keep; programs whose single allocations fail, since gcov's own code ends
# by a fault when one of its fails. A process that ends by a signal or by _exit leaves no counts: what
# asv-bench computes in processes of its own is counted only where other tests run it.
set -euo pipefail
cd "$(dirname "$0")/.."

# Percent of the branches.
validation_gate=100
whole_gate=82

tests=(validation)
folder=core/validation
gates=(--gate "core/validation=$validation_gate")
case "$*" in
    "")
        tests+=(bounds chain chain_kernels generate geometry geometry_kernels model routes search shorten solve
            solve_threads space benchmark fuzz io io_benchmark bench_program generate_program programs
            view_program limits)
        folder=.
        gates+=(--gate ".=$whole_gate")
        ;;
    validation) ;;
    *) echo "usage: coverage.sh [validation]" >&2; exit 2 ;;
esac

tools/install_packages.sh test
build=build/coverage
cmake --preset coverage > /dev/null
cmake --build --preset coverage --target "${tests[@]/#/test_}"

# Each program runs all its tests in one process, as every process takes a while to add its counts.
find "$build" -name '*.gcda' -delete
export ASV_TEST_SCALE=${ASV_TEST_SCALE:-0.1}
export GTEST_BRIEF=1
export GTEST_FILTER='-Signals*:FewProcesses*:TimeLimits*:*EverySignal*:*SaysThatItHasNoMemory*'
run_test() {
    "$1/tests/test_$2" > "$1/$2.log" 2>&1 && return
    tail -n 50 "$1/$2.log"
    return 1
}
export -f run_test
printf '%s\n' "${tests[@]}" | xargs -P "$(nproc)" -I{} bash -c 'run_test "$@"' - "$build" {}

tools/coverage/table.py "$build" "$folder" "${gates[@]}"
