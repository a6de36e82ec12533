#include "core/benchmark/comparison.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace asv::core {
namespace {

BenchmarkPlan plan_of(std::size_t problems, std::size_t planners) {
    BenchmarkPlan plan;
    plan.problems.resize(problems);
    plan.planners.resize(planners);
    plan.time_limit = 10;
    return plan;
}

BenchmarkRun solved(std::size_t problem, std::size_t planner, std::uint64_t seed, double time,
                    double cost) {
    BenchmarkRun run;
    run.place = {problem, planner, Direction::forward, seed};
    run.status = RunStatus::solved;
    run.spent.time_to_first = time;
    run.spent.cost = cost;
    return run;
}

BenchmarkRun unsolved(std::size_t problem, std::size_t planner, std::uint64_t seed) {
    BenchmarkRun run;
    run.place = {problem, planner, Direction::forward, seed};
    run.status = RunStatus::timeout;
    return run;
}

TEST(ComparePlanners, HandValues) {
    std::vector<BenchmarkRun> runs;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const auto scale = static_cast<double>(seed);
        runs.push_back(solved(0, 0, seed, scale / 100, 3));
        runs.push_back(solved(0, 1, seed, scale / 25, 2));
    }
    const auto comparisons = compare_planners(plan_of(1, 2), runs);
    ASSERT_EQ(comparisons.size(), 2U);
    const Comparison& time = comparisons[0];
    EXPECT_EQ(time.measure, Measure::time);
    EXPECT_EQ(time.test.pairs, 5U);
    EXPECT_DOUBLE_EQ(time.test.p, 2.0 / 32);
    EXPECT_DOUBLE_EQ(time.corrected_p, 4.0 / 32) << "two rows";
    EXPECT_DOUBLE_EQ(time.ratio, 0.25);
    EXPECT_DOUBLE_EQ(time.ratio_interval.low, 0.25);
    EXPECT_DOUBLE_EQ(time.ratio_interval.high, 0.25);
    // Of 1 to 5 and 4, 8, ...: 1, 2, 3 are less than 5 others, 4 equals one, 5 is less than 4.
    EXPECT_DOUBLE_EQ(time.chance_of_less, (15 + 4.5 + 4) / 25);
    EXPECT_EQ(time.first_better, 1U);
    EXPECT_EQ(time.second_better, 0U);
    const Comparison& cost = comparisons[1];
    EXPECT_EQ(cost.measure, Measure::cost);
    EXPECT_DOUBLE_EQ(cost.ratio, 1.5);
    EXPECT_DOUBLE_EQ(cost.chance_of_less, 0);
    EXPECT_EQ(cost.second_better, 1U);
}

TEST(ComparePlanners, ARunThatIsNotSolvedCountsWithTheLimitInTimesAndNotInCosts) {
    const std::vector<BenchmarkRun> runs{
        solved(0, 0, 1, 1, 5), unsolved(0, 0, 2), unsolved(0, 0, 3),        // of the first
        unsolved(0, 1, 1),     unsolved(0, 1, 2), solved(0, 1, 3, 2.5, 4),  // of the second
    };
    const auto comparisons = compare_planners(plan_of(1, 2), runs);
    ASSERT_EQ(comparisons.size(), 1U) << "no pair of costs";
    EXPECT_EQ(comparisons[0].test.pairs, 3U);
    EXPECT_EQ(comparisons[0].test.differing, 2U);
    // The logarithms of 1/10 and 10/2.5: the greater magnitude has rank 3, both unsolved rank 1.
    EXPECT_DOUBLE_EQ(comparisons[0].test.negative_ranks, 3);
    EXPECT_DOUBLE_EQ(comparisons[0].test.positive_ranks, 2);
    EXPECT_DOUBLE_EQ(comparisons[0].ratio, 1);
}

TEST(ComparePlanners, PairsHaveOneProblemDirectionAndSeed) {
    std::vector<BenchmarkRun> runs{solved(0, 0, 1, 1, 1), solved(0, 1, 2, 1, 1),
                                   solved(1, 1, 1, 1, 1)};
    EXPECT_TRUE(compare_planners(plan_of(2, 2), runs).empty());
    runs.push_back(solved(0, 1, 1, 1, 1));
    runs.back().place.direction = Direction::reversed;
    EXPECT_TRUE(compare_planners(plan_of(2, 2), runs).empty());
    runs.push_back(solved(1, 0, 1, 2, 1));
    const auto comparisons = compare_planners(plan_of(2, 2), runs);
    ASSERT_EQ(comparisons.size(), 2U);
    EXPECT_EQ(comparisons[0].test.pairs, 1U);
    EXPECT_DOUBLE_EQ(comparisons[0].ratio, 2);
}

TEST(ComparePlanners, EveryTwoPlannersByEachMeasure) {
    std::vector<BenchmarkRun> runs;
    for (std::size_t planner = 0; planner < 4; ++planner)
        runs.push_back(solved(0, planner, 1, 1, 1));
    const auto comparisons = compare_planners(plan_of(1, 4), runs);
    ASSERT_EQ(comparisons.size(), 12U);
    EXPECT_EQ(comparisons[5].first, 2U);
    EXPECT_EQ(comparisons[5].second, 3U);
    EXPECT_EQ(comparisons[6].measure, Measure::cost);
}

/// A planner that is faster on each of two tasks of different lengths is so in the table as well,
/// though its runs on the long one are slower than the other's on the short one.
TEST(ComparePlanners, TasksOfDifferentLengthsAreNotMixed) {
    std::vector<BenchmarkRun> runs;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
        for (std::size_t problem = 0; problem < 2; ++problem) {
            const double length = problem == 0 ? 0.001 : 1;
            runs.push_back(solved(problem, 0, seed, length, 1));
            runs.push_back(solved(problem, 1, seed, 2 * length, 1));
        }
    const auto comparisons = compare_planners(plan_of(2, 2), runs);
    EXPECT_EQ(comparisons[0].chance_of_less, 1);
    EXPECT_EQ(comparisons[0].first_better, 2U);
    EXPECT_DOUBLE_EQ(comparisons[0].test.p, 2.0 / 256);
    EXPECT_EQ(comparisons[1].test.p, 1) << "costs are equal";
    EXPECT_EQ(comparisons[1].chance_of_less, 0.5);
}

TEST(ComparePlanners, WhatTakesNoTimeAndCostsNothingHasARatio) {
    const std::vector<BenchmarkRun> runs{solved(0, 0, 1, 0, 0), solved(0, 1, 1, 1, 0)};
    const auto comparisons = compare_planners(plan_of(1, 2), runs);
    ASSERT_EQ(comparisons.size(), 2U);
    EXPECT_TRUE(std::isfinite(comparisons[0].ratio));
    EXPECT_EQ(comparisons[1].ratio, 1);
}

}  // namespace
}  // namespace asv::core
