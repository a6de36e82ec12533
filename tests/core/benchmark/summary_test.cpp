#include "core/benchmark/summary.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace asv::core {
namespace {

TEST(Quantile, LiesBetweenNeighbours) {
    const std::array<double, 4> values{1, 2, 4, 8};
    EXPECT_DOUBLE_EQ(quantile(values, 0), 1);
    EXPECT_DOUBLE_EQ(quantile(values, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 3);
    EXPECT_DOUBLE_EQ(quantile(values, 1), 8);
    EXPECT_DOUBLE_EQ(quantile(std::array<double, 1>{5}, 0.5), 5);
}

TEST(SpreadOf, HandValues) {
    const Spread spread = spread_of({9, 2, 4, 4, 5, 4, 5, 7});
    EXPECT_EQ(spread.count, 8U);
    EXPECT_DOUBLE_EQ(spread.least, 2);
    EXPECT_DOUBLE_EQ(spread.median, 4.5);
    EXPECT_DOUBLE_EQ(spread.greatest, 9);
    EXPECT_DOUBLE_EQ(spread.mean, 5);
    // Squares of the differences: 9 + 1 + 1 + 1 + 0 + 0 + 4 + 16 = 32.
    EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(32.0 / 7));
}

TEST(SpreadOf, OfOneAndOfNone) {
    EXPECT_DOUBLE_EQ(spread_of({3}).median, 3);
    EXPECT_DOUBLE_EQ(spread_of({3}).deviation, 0);
    EXPECT_EQ(spread_of({}).count, 0U);
    EXPECT_DOUBLE_EQ(spread_of({}).median, 0);
}

BenchmarkRun run_of(std::uint64_t seed, RunStatus status, double time, double cost, double bound) {
    BenchmarkRun run;
    run.place.seed = seed;
    run.status = status;
    run.spent.time_to_first = time;
    run.spent.cost = cost;
    run.spent.cost_lower_bound = bound;
    run.spent.tree_nodes[0] = 2;
    run.spent.tree_nodes[1] = 3;
    return run;
}

TEST(Summarise, TakesFiguresOfSolvedRunsAlone) {
    BenchmarkPlan plan;
    plan.problems.resize(1);
    plan.planners.resize(2);
    const std::vector<BenchmarkRun> runs{run_of(1, RunStatus::solved, 1, 6, 4),
                                         run_of(2, RunStatus::timeout, 100, 0, 0),
                                         run_of(3, RunStatus::solved, 3, 8, 4)};
    const std::vector<Summary> summaries = summarise(plan, runs);
    ASSERT_EQ(summaries.size(), 1U) << "the second planner has not run";
    const Summary& summary = summaries[0];
    EXPECT_EQ(summary.runs, 3U);
    EXPECT_EQ(summary.solved, 2U);
    EXPECT_DOUBLE_EQ(summary.time_to_first.median, 2);
    EXPECT_DOUBLE_EQ(summary.time_to_first.greatest, 3);
    EXPECT_DOUBLE_EQ(summary.nodes.median, 5);
    EXPECT_DOUBLE_EQ(summary.ratio.median, 1.75);
    EXPECT_DOUBLE_EQ(summary.lower_bound, 4);
}

TEST(Summarise, WithoutABoundThereIsNoRatio) {
    EXPECT_FALSE(cost_ratio(run_of(1, RunStatus::solved, 1, 6, 0)));
    EXPECT_FALSE(cost_ratio(run_of(1, RunStatus::timeout, 1, 0, 4)));
    EXPECT_DOUBLE_EQ(*cost_ratio(run_of(1, RunStatus::solved, 1, 6, 4)), 1.5);
}

}  // namespace
}  // namespace asv::core
