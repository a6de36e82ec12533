#!/usr/bin/env bash
# How much of core, geometry, io and tools the tests run, as gcov counts it: builds them without optimisation
# (preset coverage), runs the tests, prints lines and branches by room, and ends with 1 where a gate is missed.
# coverage.sh validation looks at core/validation alone, in a few minutes: the gate of what judges paths, by its
# own tests. tools/coverage/table.py tells what a branch is; `tools/coverage/table.py build/coverage
# core/search --missing` then tells which of a room were never taken.
# Not run, so not counted: pages in a browser, the commands in ours, the house, the site, Python, OMPL and MPI;
# programs whose single allocations fail, since gcov's own code ends by a fault when one of its fails; threads, and
# limits of time and of the system, which have their own builds and tests and take long here. A process leaves its
# counts where it ends in order or by tools/common/end_at_once.hpp, and none where a signal ends it. Whether a test
# passes is for the other builds to say: so slow a one does not keep the time limits of all; it names those that fail.
set -euo pipefail
cd "$(dirname "$0")/.."

# Percent of the branches.
validation_gate=100
whole_gate=90

tests=(validation)
with_manuals=false
folder=core/validation
gates=(--gate "core/validation=$validation_gate")
case "$*" in
    "")
        # Those first that take long.
        tests=(bench_program search "${tests[@]}" solve programs generate chain_kernels bounds chain geometry
            geometry_kernels model routes shorten space benchmark certificate_check certificate_files fuzz io
            io_benchmark generate_program trajectory view_program)
        with_manuals=true
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

find "$build" -name '*.gcda' -delete
# The programs write their manuals, anew where this build has them: that counts too.
if $with_manuals; then
    rm -rf "$build/share"
    cmake --build --preset coverage --target manuals > /dev/null
fi

# Tests of very many cases or of every planner, minutes in so slow a build; hardly a branch is theirs alone.
left_out=(
    '*SaysThatItHasNoMemory*'
    BatchChecker.OneSeedGivesOnePathAndOneCountOnEveryTarget
    BenchProgram.AllStandsForEveryPlanner
    BenchProgram.ARunIsThatOfAsvSolve
    Certificates.ThatAreChangedOtherwiseAreRefusedOrTrue
    Certificates.WithANumberChangedAreRefused
    CorridorCertificate.IsAcceptedUpToWhatIsProven
    CorridorCertificate.IsRefusedWhereTheChainHasRoom
    EmptyRegion.IsNoneWhereAStateOfAPathHasItsMiddle
    EmptyRegion.IsTheMiddleOfACorridorThatIsTooLow
    ExternalPlanner.EndsAreToldApart
    GenerateProgram.VerdictIsInTheSideFile
    ImproveAlongRoutes.SameSeedSamePath
    LineCheck.ProvesWhatIsValidAndNothingElse
    LowCorridors.AreNeverAReasonWhereThereIsAPath
    'MemoryLimit.*'
    Motion.PrefixEndsShortlyBeforeTheFirstInvalidState
    MotionProof.AThousandSamplesForEveryPrimitiveStepFindNothing
    Ours/EveryPlanner.SolvesAnEasyOne/prm_bridge
    Ours/EveryPlanner.SolvesAnEasyOne/prm_gaussian
    Ours/EveryPlanner.SolvesAnEasyOne/prm_grid
    Ours/EveryPlanner.SolvesAnEasyOne/rrt_star
    Ours/EveryScenario.IsSolvedValidatedAndShown/chain_by_hand
    'Ours/EverySolvableTestCase.*15ASV*'
    Ours/MethodA.SolvesIt/3ASV_clutter_20
    PassageCheck.FindsNothingWhereTheChainHooksThrough
    PassageCheck.NeverClosesWhatThePlannerPasses
    Picture.HoldsAHundredThousandObstacles
    Replan.EveryPlannerFindsAPath
    Resume.ASweepThatIsKilledAgainAndAgainGivesTheSameRows
    RrtStar.PathsGetShorterAsTheBudgetGrows
    'SameBytes.*'
    SetOfProblems.ASampleIsSolvedAndCostsNoLessThanTheBound
    SetOfProblems.RunsBesideFilesUnderItsOwnNames
    SetOfProblems.ThoseWithoutAPathAreNeverReportedSolved
    'Soak.*'
    Solve.ImprovingNeverCostsMore
    Solve.NeverClaimsThatNothingIsLeftWhereThereIs
    Solve.TheLastCostOfTheHistoryIsThatOfTheSolution
    'Solve/EachImage.*'
    SolvePlanners.EveryPlannerSolvesAnEasyOne
    SolvePlanners.EverySamplerServesEveryPlanner
    SolvePlanners.RrtConnectSolvesBySingleSteps
    SolvePlanners.RrtStarTellsWhenItsFirstPathWasThere
    SolveProgram.SameSeedSameBytesOtherSeedOtherPath
    Toy/EachPlanner.FindsTheDoor/GoalThenStart
    Toy/EachPlanner.ObserversSeeTheSearchAndDoNotChangeIt/StartThenGoal
    Toy/EachPlanner.SameSeedSamePath/StartThenGoal
    'Toy/EachSampledPlanner.SameSeedSamePathWatchedOrNot/Rrt*'
    Vouch.NeverVouchesForWhatCannotBe
)
# Each program of tests runs all its tests in one process, as every process takes a while to add its counts.
export ASV_TEST_SCALE=${ASV_TEST_SCALE:-0.1}
export GTEST_BRIEF=1
GTEST_FILTER="-$(IFS=: && echo "${left_out[*]}")"
export GTEST_FILTER
run_test() {
    "$1/tests/test_$2" > "$1/$2.log" 2>&1 || echo "test_$2: not every test has passed, see $1/$2.log"
}
export -f run_test
printf '%s\n' "${tests[@]}" | xargs -P "$(nproc)" -I{} bash -c 'run_test "$@"' - "$build" {}
# What CTest runs of the programs besides: their manuals.
if $with_manuals; then
    ctest --test-dir "$build" -j "$(nproc)" --output-on-failure -R '^manual\.' > "$build/manuals.log" ||
        echo "not every manual is as it should be, see $build/manuals.log"
fi

tools/coverage/table.py "$build" "$folder" "${gates[@]}"
