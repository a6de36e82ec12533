#include "core/benchmark/curves.hpp"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace asv::core {
namespace {

using Factors = std::vector<double>;
using statistics::CensoredValue;

BenchmarkRun run_of(std::size_t problem, std::size_t planner, std::optional<double> time) {
    BenchmarkRun run;
    run.place = {problem, planner, Direction::forward, 1};
    run.status = time ? RunStatus::solved : RunStatus::timeout;
    run.spent.time_to_first = time.value_or(0);
    return run;
}

BenchmarkPlan plan_with(std::size_t problems, std::size_t planners) {
    BenchmarkPlan plan;
    plan.problems.resize(problems);
    plan.planners.resize(planners);
    return plan;
}

TEST(PerformanceProfiles, HandValues) {
    const std::vector<BenchmarkRun> runs{run_of(0, 0, 1),
                                         run_of(0, 1, 2),  // the first is best
                                         run_of(1, 0, 8),
                                         run_of(1, 1, 2),  // the second is
                                         run_of(2, 0, 3),
                                         run_of(2, 1, std::nullopt),  // only the first solves it
                                         run_of(3, 0, std::nullopt),
                                         run_of(3, 1, std::nullopt)};
    const auto profiles = performance_profiles(plan_with(4, 3), runs);
    ASSERT_EQ(profiles.size(), 2U) << "the third planner has not run";
    EXPECT_EQ(profiles[0].tasks, 4U);
    EXPECT_EQ(profiles[0].factors, (Factors{1, 1, 4}));
    EXPECT_EQ(profiles[1].planner, 1U);
    EXPECT_EQ(profiles[1].factors, (Factors{1, 2}));
}

TEST(PerformanceProfiles, TakeTheMedianOfAllRuns) {
    std::vector<BenchmarkRun> runs{run_of(0, 0, 1), run_of(0, 0, std::nullopt),
                                   run_of(0, 0, std::nullopt), run_of(0, 1, 5)};
    for (std::size_t i = 0; i < 3; ++i) runs[i].place.seed = i;
    const auto profiles = performance_profiles(plan_with(1, 2), runs);
    EXPECT_TRUE(profiles[0].factors.empty()) << "it solves one run of three";
    EXPECT_EQ(profiles[1].factors, Factors{1});
}

TEST(CostOverTime, IsThatOfTheBestPathsSoFar) {
    std::vector<BenchmarkRun> runs(3);
    for (BenchmarkRun& run : runs) run.status = RunStatus::solved;
    runs[0].spent.cost_history = {{1, 10}, {3, 6}};
    runs[1].spent.cost_history = {{2, 8}};
    runs[2].spent.cost_history = {{4, 20}, {4, 12}};
    const auto quartiles = cost_over_time(runs, std::vector<double>{0.5, 1, 2, 4});
    EXPECT_TRUE(quartiles[0].lower.censored);
    EXPECT_TRUE(quartiles[1].median.censored);
    EXPECT_EQ(quartiles[2].median, (CensoredValue{10, false}));
    EXPECT_TRUE(quartiles[2].upper.censored);
    EXPECT_EQ(quartiles[3].lower, (CensoredValue{7, false}));
    EXPECT_EQ(quartiles[3].median, (CensoredValue{8, false}));
    EXPECT_EQ(quartiles[3].upper, (CensoredValue{10, false}));
}

}  // namespace
}  // namespace asv::core
