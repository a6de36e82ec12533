#include "tests/kit/files/benchmark_report_sample.hpp"

namespace asv::test {

namespace {

core::BenchmarkPlan sample_plan() {
    core::Problem problem;
    problem.start = {{0.1, 0.1}, {0.15, 0.1}, {0.15, 0.15}};
    problem.goal = {{0.8, 0.8}, {0.85, 0.8}, {0.85, 0.85}};
    problem.obstacles = {{{0.4, 0.4}, {0.6, 0.6}}};
    core::BenchmarkPlanner swaps{"swaps|1", core::RrtConnectPlanner{}, {{"swap-limiter", "on"}}};
    core::set(swaps.planner, "swap-limiter", "on");
    core::BenchmarkPlan plan;
    plan.problems = {{"first", "cases/first.txt", problem},
                     {"second, it", "cases/second, it.txt", problem}};
    plan.planners = {{"auto", core::AutoPlanner{}, {}}, swaps};
    plan.directions = {core::Direction::forward, core::Direction::reversed};
    plan.first_seed = 3;
    plan.seeds = 2;
    return plan;
}

core::BenchmarkRun sample_run(const core::RunPlace& place) {
    core::BenchmarkRun run;
    run.place = place;
    const bool reversed = place.direction == core::Direction::reversed;
    if (place.problem == 0 && place.planner == 1 && reversed && place.seed == 4) {
        run.status = core::RunStatus::timeout;
        run.reason = "no path found: deadline";
        run.spent.time_total = 10;
        run.spent.tree_nodes[0] = 1000;
        return run;
    }
    const double scale = (place.planner == 0 ? 1 : 4) * (place.seed == 3 ? 1 : 3);
    run.status = core::RunStatus::solved;
    run.primitive_steps = 700;
    run.peak_memory_bytes = 3 << 20;
    core::SolveStatistics& spent = run.spent;
    spent.time_to_first = scale / 64;
    spent.time_total = scale / 64 + 0.5;
    spent.cost_first = 3;
    spent.cost_of_search = 2.75;
    spent.cost = 2.5;
    spent.cost_lower_bound = 2;
    spent.steps_lower_bound = 600;
    spent.tree_nodes[0] = 10;
    spent.tree_nodes[1] = 20;
    spent.iterations = 7;
    spent.state_checks = 400;
    spent.edge_checks = 50;
    spent.cost_history = {{scale / 64, 3}, {scale / 64 + 0.25, 2.5}};
    return run;
}

}  // namespace

io::BenchmarkReport sample_report() {
    io::BenchmarkReport report;
    report.plan = sample_plan();
    for (const core::RunPlace& place : core::places(report.plan))
        report.runs.push_back(sample_run(place));
    report.session = {"1.2.3", "host", "CPU", 2, {}, 12.5, 0.125, 0.375};
    return report;
}

}  // namespace asv::test
