#include "core/benchmark/parameter_curves.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace asv::core {
namespace {

BenchmarkProblem problem_with(std::size_t asvs, double height) {
    BenchmarkProblem problem;
    problem.problem.start.resize(asvs);
    problem.parameters = {{"height", height}};
    return problem;
}

/// Two problems of 3 ASVs, one of 7, two planners.
BenchmarkPlan sample_plan() {
    BenchmarkPlan plan;
    plan.problems = {problem_with(7, 0.2), problem_with(3, 0.1), problem_with(3, 0.2)};
    plan.planners.resize(2);
    plan.time_limit = 10;
    return plan;
}

BenchmarkRun run_at(std::size_t problem, std::size_t planner, double seconds) {
    BenchmarkRun run;
    run.place = {problem, planner, Direction::forward, 1};
    run.status = seconds < 10 ? RunStatus::solved : RunStatus::timeout;
    run.spent.time_to_first = seconds;
    return run;
}

TEST(ParameterOf, IsTheSizeOfTheProblemOrWhatItWasGeneratedWith) {
    const BenchmarkProblem problem = problem_with(7, 0.2);
    EXPECT_EQ(parameter_of(problem, "n"), 7);
    EXPECT_EQ(parameter_of(problem, "obstacles"), 0);
    EXPECT_EQ(parameter_of(problem, "height"), 0.2);
    EXPECT_FALSE(parameter_of(problem, "width"));
}

TEST(ParameterCurves, PutRunsOfOneValueTogether) {
    const std::vector<BenchmarkRun> runs{run_at(0, 0, 4), run_at(1, 0, 1), run_at(2, 0, 3)};
    const auto curves = parameter_curves(sample_plan(), runs, "n");
    ASSERT_EQ(curves.size(), 1U);
    ASSERT_EQ(curves[0].points.size(), 2U);
    const ParameterPoint &small = curves[0].points[0], &large = curves[0].points[1];
    EXPECT_EQ(small.value, 3);
    EXPECT_EQ(small.runs, 2U);
    EXPECT_EQ(small.median_time, (statistics::CensoredValue{2, false}));
    EXPECT_EQ(small.median_interval.low.value, 1);
    EXPECT_EQ(small.median_interval.high.value, 3);
    EXPECT_EQ(large.value, 7);
    EXPECT_EQ(large.median_time, (statistics::CensoredValue{4, false}));
}

TEST(ParameterCurves, RunsWithoutASolutionCount) {
    const std::vector<BenchmarkRun> runs{run_at(0, 1, 2), run_at(2, 1, 10), run_at(1, 1, 10)};
    const auto curves = parameter_curves(sample_plan(), runs, "height");
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(curves[0].planner, 1U);
    ASSERT_EQ(curves[0].points.size(), 2U);
    EXPECT_EQ(curves[0].points[0].solved, 0U);
    EXPECT_TRUE(curves[0].points[0].median_time.censored);
    EXPECT_EQ(curves[0].points[1].solved, 1U);
    EXPECT_EQ(curves[0].points[1].runs, 2U);
    EXPECT_TRUE(curves[0].points[1].median_time.censored);
    EXPECT_LT(curves[0].points[1].success.low, 0.5);
}

TEST(ParameterCurves, LeaveOutWhatHasNoSuchParameter) {
    EXPECT_TRUE(parameter_curves(sample_plan(), std::vector{run_at(0, 0, 1)}, "width").empty());
}

}  // namespace
}  // namespace asv::core
