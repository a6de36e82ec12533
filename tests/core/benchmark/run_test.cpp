#include "core/benchmark/run.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/benchmark/machine_unit.hpp"
#include "core/validation/validate.hpp"
#include "io/problem/problem_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/solving.hpp"

namespace asv::core {
namespace {

BenchmarkProblem problem_named(const std::string& name) {
    const std::string file = test::testcase_file(name + ".txt");
    return {name, file, io::read_problem(file).problem};
}

BenchmarkPlan small_plan() {
    BenchmarkPlan plan;
    plan.problems = {problem_named("3ASV"), problem_named("3ASV-x4")};
    plan.planners = {{"auto", AutoPlanner{}, {}}, {"rrt-connect", RrtConnectPlanner{}, {}}};
    plan.directions = {Direction::forward, Direction::reversed};
    plan.first_seed = 5;
    plan.seeds = 2;
    plan.time_limit = 600;  // under sanitizers on a busy machine, too
    return plan;
}

void expect_same_work(const SolveStatistics& a, const SolveStatistics& b) {
    EXPECT_EQ(a.cost_first, b.cost_first);
    EXPECT_EQ(a.cost_of_search, b.cost_of_search);
    EXPECT_EQ(a.cost, b.cost);
    EXPECT_EQ(a.cost_lower_bound, b.cost_lower_bound);
    EXPECT_EQ(a.tree_nodes[0], b.tree_nodes[0]);
    EXPECT_EQ(a.tree_nodes[1], b.tree_nodes[1]);
    EXPECT_EQ(a.iterations, b.iterations);
    EXPECT_EQ(a.state_checks, b.state_checks);
    EXPECT_EQ(a.edge_checks, b.edge_checks);
}

TEST(RunBenchmark, RunsAllInTheOrderOfThePlaces) {
    const BenchmarkPlan plan = small_plan();
    const auto runs = run_benchmark(plan);
    const auto expected = places(plan);
    ASSERT_EQ(runs.size(), 16U);
    ASSERT_EQ(run_count(plan), 16U);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const RunPlace& place = runs[i].place;
        EXPECT_EQ(place.problem, expected[i].problem);
        EXPECT_EQ(place.planner, expected[i].planner);
        EXPECT_EQ(place.direction, expected[i].direction);
        EXPECT_EQ(place.seed, expected[i].seed);
        EXPECT_TRUE(runs[i].solved()) << runs[i].fault << runs[i].reason;
    }
}

TEST(RunBenchmark, EachRunIsThatOfTheFacade) {
    const BenchmarkPlan plan = small_plan();
    for (const BenchmarkRun& run : run_benchmark(plan)) {
        SolveOptions options;
        options.planner = plan.planners[run.place.planner].planner;
        options.seed = run.place.seed;
        options.time_limit = plan.time_limit;
        options.optimize = plan.optimize;
        options.reverse = run.place.direction == Direction::reversed;
        const SolveResult result = solve(plan.problems[run.place.problem].problem, options);
        expect_same_work(run.spent, result.statistics);
        EXPECT_EQ(run.primitive_steps, result.solution->path.size() - 1);
    }
}

TEST(RunBenchmark, RunsTheChosenPlacesAlone) {
    const BenchmarkPlan plan = small_plan();
    const std::vector<RunPlace> chosen{{1, 1, Direction::reversed, 6},
                                       {0, 1, Direction::forward, 5}};
    const auto runs = run_benchmark(plan, chosen);
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].place, chosen[1]);
    EXPECT_EQ(runs[1].place, chosen[0]);
}

TEST(RunStatus, EachHasAName) {
    std::set<std::string_view> names;
    for (const RunStatus status : all_run_statuses) names.insert(name(status));
    EXPECT_EQ(names.size(), all_run_statuses.size());
    EXPECT_FALSE(names.contains("unknown"));
}

TEST(RunBenchmark, SideBySideTheWorkIsTheSame) {
    BenchmarkPlan plan = small_plan();
    const auto one = run_benchmark(plan);
    plan.jobs = 4;
    const auto four = run_benchmark(plan);
    ASSERT_EQ(one.size(), four.size());
    for (std::size_t i = 0; i < one.size(); ++i) expect_same_work(one[i].spent, four[i].spent);
}

TEST(RunBenchmark, PlannersTakeTurns) {
    const BenchmarkPlan plan = small_plan();
    std::vector<RunPlace> begun;
    BenchmarkWatch watch;
    watch.before = [&](const RunPlace& place) { begun.push_back(place); };
    run_benchmark(plan, watch);
    for (std::size_t i = 0; i + 1 < begun.size(); i += 2) {
        EXPECT_EQ(begun[i].seed, begun[i + 1].seed);
        EXPECT_EQ(begun[i].planner, 0U);
        EXPECT_EQ(begun[i + 1].planner, 1U);
    }
}

TEST(RunBenchmark, EnoughEndsItAfterTheRun) {
    std::stop_source enough;
    BenchmarkWatch watch;
    watch.enough = enough.get_token();
    watch.before = [&, begun = 0](const RunPlace&) mutable {
        if (++begun == 3) enough.request_stop();
    };
    EXPECT_EQ(run_benchmark(small_plan(), watch).size(), 3U);
}

TEST(RunBenchmark, AnAbortedRunIsDropped) {
    std::stop_source abort;
    BenchmarkWatch watch;
    watch.abort = abort.get_token();
    watch.before = [&, begun = 0](const RunPlace&) mutable {
        if (++begun == 3) abort.request_stop();
    };
    EXPECT_EQ(run_benchmark(small_plan(), watch).size(), 2U);
}

TEST(RunBenchmark, AnUnsolvedRunIsAResult) {
    BenchmarkPlan plan = small_plan();
    plan.time_limit = 0;
    for (const BenchmarkRun& run : run_benchmark(plan)) {
        EXPECT_FALSE(run.solved());
        EXPECT_EQ(run.status, RunStatus::timeout);
        EXPECT_FALSE(run.reason.empty());
        EXPECT_TRUE(run.fault.empty());
    }
}

TEST(RunBenchmark, AnInvalidStartIsRefusedBeforeAnythingRuns) {
    BenchmarkPlan plan = small_plan();
    plan.problems[1].problem.obstacles.push_back({{0, 0}, {1, 1}});
    BenchmarkWatch watch;
    watch.before = [](const RunPlace&) { FAIL() << "it ran"; };
    EXPECT_THROW(run_benchmark(plan, watch), std::invalid_argument);
}

TEST(FaultOf, NamesWhatIsWrong) {
    const Problem problem = problem_named("3ASV").problem;
    Solution solution = *solve(problem, test::plain(1)).solution;
    EXPECT_EQ(fault_of(problem, solution), "");
    solution.cost += 1;
    EXPECT_TRUE(fault_of(problem, solution).starts_with("cost: ")) << fault_of(problem, solution);
    Problem blocked = problem;
    const Point middle = solution.path.state(solution.path.size() / 2)[0];
    // So thin that only the motion between two states may meet it.
    blocked.obstacles.push_back({{middle.x - 1e-4, middle.y - 1e-4}, {middle.x, middle.y}});
    EXPECT_NE(fault_of(blocked, solution), "");
}

TEST(MachineUnit, IsATime) {
    EXPECT_GT(seconds_per_million_checks(), 0);
}

}  // namespace
}  // namespace asv::core
