#include "core/benchmark/summary.hpp"

#include <gtest/gtest.h>

namespace asv::core {
namespace {

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

BenchmarkPlan one_problem_two_planners() {
    BenchmarkPlan plan;
    plan.problems.resize(1);
    plan.planners.resize(2);
    plan.time_limit = 10;
    return plan;
}

TEST(Summarise, CostsAndWorkAreOfSolvedRunsAlone) {
    const std::vector<BenchmarkRun> runs{run_of(1, RunStatus::solved, 1, 6, 4),
                                         run_of(2, RunStatus::timeout, 100, 0, 0),
                                         run_of(3, RunStatus::solved, 3, 8, 4)};
    const std::vector<Summary> summaries = summarise(one_problem_two_planners(), runs);
    ASSERT_EQ(summaries.size(), 1U) << "the second planner has not run";
    const Summary& summary = summaries[0];
    EXPECT_EQ(summary.runs, 3U);
    EXPECT_EQ(summary.solved, 2U);
    EXPECT_DOUBLE_EQ(summary.time_to_first.median, 2);
    EXPECT_DOUBLE_EQ(summary.time_to_first.greatest, 3);
    EXPECT_DOUBLE_EQ(summary.nodes.median, 5);
    EXPECT_DOUBLE_EQ(summary.ratio.median, 1.75);
    EXPECT_DOUBLE_EQ(summary.lower_bound, 4);
    EXPECT_DOUBLE_EQ(summary.median_cost.low, 6);
    EXPECT_DOUBLE_EQ(summary.median_cost.high, 8);
}

TEST(Summarise, TheWorkInsideAnotherProgramIsUnknown) {
    BenchmarkPlan plan = one_problem_two_planners();
    plan.planners[0].command = {"another", "{problem}", "{solution}"};
    const std::vector<BenchmarkRun> runs{run_of(1, RunStatus::solved, 1, 6, 4)};
    const Summary summary = summarise(plan, runs).at(0);
    EXPECT_EQ(summary.nodes.count, 0U);
    EXPECT_EQ(summary.state_checks.count, 0U);
    EXPECT_EQ(summary.cost.count, 1U);
}

TEST(Summarise, TheTimeToASolutionIsOfAllRuns) {
    const std::vector<BenchmarkRun> runs{run_of(1, RunStatus::timeout, 0, 0, 0),
                                         run_of(2, RunStatus::solved, 1, 6, 4),
                                         run_of(3, RunStatus::infeasible, 0, 0, 0)};
    const Summary summary = summarise(one_problem_two_planners(), runs).at(0);
    EXPECT_EQ(statistics::quantile(summary.time_to_solution, 0.5),
              (statistics::CensoredValue{10, true}));
    EXPECT_DOUBLE_EQ(statistics::penalised_mean(summary.time_to_solution), (1 + 20 + 20) / 3.0);
    EXPECT_EQ(summary.median_time.high, (statistics::CensoredValue{10, true}));
    EXPECT_LT(summary.success.low, 1.0 / 3);
    EXPECT_GT(summary.success.high, 1.0 / 3);
}

TEST(Summarise, OverProblemsAllRunsOfAPlannerAreTogether) {
    BenchmarkPlan plan = one_problem_two_planners();
    plan.problems.resize(2);
    plan.directions = {Direction::forward, Direction::reversed};
    std::vector<BenchmarkRun> runs{
        run_of(1, RunStatus::solved, 1, 6, 4), run_of(1, RunStatus::invalid, 2, 0, 4),
        run_of(1, RunStatus::timeout, 0, 0, 4), run_of(1, RunStatus::solved, 7, 6, 4)};
    runs[1].place.problem = runs[2].place.problem = 1;
    runs[3].place.direction = Direction::reversed;
    const std::vector<Summary> summaries = summarise_over_problems(plan, runs);
    ASSERT_EQ(summaries.size(), 2U) << "one for each direction; the second planner has not run";
    EXPECT_EQ(summaries[0].runs, 3U);
    EXPECT_EQ(summaries[0].solved, 1U);
    EXPECT_EQ(summaries[0].invalid, 1U);
    EXPECT_EQ(summaries[1].direction, Direction::reversed);
    EXPECT_EQ(summaries[1].runs, 1U);
    EXPECT_DOUBLE_EQ(summaries[1].time_to_first.median, 7);
}

TEST(Summarise, WithoutABoundThereIsNoRatio) {
    EXPECT_FALSE(cost_ratio(run_of(1, RunStatus::solved, 1, 6, 0)));
    EXPECT_FALSE(cost_ratio(run_of(1, RunStatus::timeout, 1, 0, 4)));
    EXPECT_DOUBLE_EQ(*cost_ratio(run_of(1, RunStatus::solved, 1, 6, 4)), 1.5);
}

}  // namespace
}  // namespace asv::core
