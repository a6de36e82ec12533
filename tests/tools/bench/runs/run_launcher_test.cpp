#include "tools/bench/runs/run_launcher.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/kit/chains/problems.hpp"

namespace asv::tools {
namespace {

core::BenchmarkPlan plan_of(const std::string& name) {
    const std::string file = test::testcase_file(name + ".txt");
    core::BenchmarkPlan plan;
    plan.problems = {{name, file, test::testcase(name + ".txt")}};
    plan.planners = {{"auto", core::AutoPlanner{}, {}}};
    plan.optimize = 0.05;
    return plan;
}

TEST(RunLauncher, IsTheRunThatWouldBeHere) {
    const core::BenchmarkPlan plan = plan_of("3ASV");
    const core::RunPlace place{0, 0, core::Direction::reversed, 9};
    const core::BenchmarkRun child = RunLauncher(plan).run(place, {});
    const core::BenchmarkRun here = core::run_once(plan, place);
    EXPECT_EQ(child.place.seed, 9U);
    EXPECT_EQ(child.place.direction, core::Direction::reversed);
    EXPECT_EQ(child.status, core::RunStatus::solved);
    EXPECT_EQ(child.fault, "");
    EXPECT_EQ(child.primitive_steps, here.primitive_steps);
    EXPECT_EQ(child.spent.cost_first, here.spent.cost_first);
    EXPECT_EQ(child.spent.cost_of_search, here.spent.cost_of_search);
    EXPECT_EQ(child.spent.cost, here.spent.cost);
    EXPECT_EQ(child.spent.cost_lower_bound, here.spent.cost_lower_bound);
    EXPECT_EQ(child.spent.steps_lower_bound, here.spent.steps_lower_bound);
    EXPECT_EQ(child.spent.tree_nodes[0], here.spent.tree_nodes[0]);
    EXPECT_EQ(child.spent.tree_nodes[1], here.spent.tree_nodes[1]);
    EXPECT_EQ(child.spent.iterations, here.spent.iterations);
    EXPECT_EQ(child.spent.state_checks, here.spent.state_checks);
    EXPECT_EQ(child.spent.edge_checks, here.spent.edge_checks);
    ASSERT_EQ(child.spent.cost_history.size(), here.spent.cost_history.size());
    for (std::size_t i = 0; i < child.spent.cost_history.size(); ++i)
        EXPECT_EQ(child.spent.cost_history[i].second, here.spent.cost_history[i].second);
    EXPECT_GT(child.spent.time_to_first, 0);
    EXPECT_GE(child.spent.time_total, child.spent.time_to_first);
    EXPECT_GT(child.peak_memory_bytes.value_or(1), 0U);
}

TEST(RunLauncher, TellsWhyThereIsNoPath) {
    core::BenchmarkPlan plan = plan_of("infeasible/opposite-orientation");
    const core::BenchmarkRun run = RunLauncher(plan).run({}, {});
    EXPECT_EQ(run.status, core::RunStatus::infeasible);
    EXPECT_FALSE(run.reason.empty());
}

TEST(RunLauncher, WhatIsThrownThereIsAFault) {
    core::BenchmarkPlan plan = plan_of("3ASV");
    plan.problems[0].problem.obstacles.push_back({{0, 0}, {1, 1}});
    const core::BenchmarkRun run = RunLauncher(plan).run({}, {});
    EXPECT_NE(run.fault.find("not valid"), std::string::npos) << run.fault;
}

TEST(RunLauncher, WithoutAnAnswerTheRunHasAFault) {
    const core::BenchmarkRun run = answered_run(std::nullopt, {0, 0, core::Direction::reversed, 9});
    EXPECT_EQ(run.fault, "the process that starts the runs has ended");
    EXPECT_EQ(run.place.seed, 9U);
}

TEST(RunLauncher, AbortEndsIt) {
    core::BenchmarkPlan plan = plan_of("infeasible/wall-across");
    plan.time_limit = 3600;
    std::stop_source abort;
    abort.request_stop();
    const core::BenchmarkRun run = RunLauncher(plan).run({}, abort.get_token());
    EXPECT_FALSE(run.solved());
    EXPECT_EQ(run.fault, "");
}

}  // namespace
}  // namespace asv::tools
