#include "core/benchmark/summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace asv::core {

namespace {

using statistics::CensoredInterval;
using statistics::CensoredSample;

/// The values of the solved runs, ascending; a run may have none.
template <class Value>
std::vector<double> values_of(std::span<const BenchmarkRun> runs, const Value& value) {
    std::vector<double> values;
    for (const BenchmarkRun& run : runs)
        if (run.solved())
            if (const std::optional<double> found = value(run)) values.push_back(*found);
    std::sort(values.begin(), values.end());
    return values;
}

double time_of(const BenchmarkRun& run) {
    return run.spent.time_to_first;
}

double cost_of(const BenchmarkRun& run) {
    return run.spent.cost;
}

void summarise_times(Summary& summary, std::span<const BenchmarkRun> runs, double time_limit) {
    std::vector<double> times = values_of(runs, time_of);
    summary.runs = runs.size();
    summary.solved = times.size();
    summary.success = statistics::success_interval(summary.solved, summary.runs);
    summary.time_to_first = statistics::spread_of(times);
    summary.time_to_solution = {std::move(times), summary.runs - summary.solved, time_limit};
    summary.median_time = statistics::median_interval(summary.time_to_solution);
}

void summarise_costs(Summary& summary, std::span<const BenchmarkRun> runs) {
    std::vector<double> costs = values_of(runs, cost_of);
    if (costs.empty()) return;
    summary.cost = statistics::spread_of(costs);
    const CensoredInterval interval =
        statistics::median_interval(CensoredSample{std::move(costs), 0, 0});
    summary.median_cost = {interval.low.value, interval.high.value};
}

Summary summary_of(std::span<const BenchmarkRun> runs, double time_limit) {
    const auto over = [&](auto value) {
        return statistics::spread_of(
            values_of(runs, [&](const BenchmarkRun& run) -> std::optional<double> {
                return static_cast<double>(std::invoke(value, run));
            }));
    };
    Summary summary;
    summary.problem = runs[0].place.problem;
    summary.planner = runs[0].place.planner;
    summary.direction = runs[0].place.direction;
    summarise_times(summary, runs, time_limit);
    summarise_costs(summary, runs);
    summary.nodes = over(node_count);
    summary.state_checks = over([](const BenchmarkRun& run) { return run.spent.state_checks; });
    summary.cost_first = over([](const BenchmarkRun& run) { return run.spent.cost_first; });
    summary.ratio = statistics::spread_of(values_of(runs, cost_ratio));
    summary.invalid = static_cast<std::size_t>(
        std::count_if(runs.begin(), runs.end(),
                      [](const BenchmarkRun& run) { return run.status == RunStatus::invalid; }));
    for (const BenchmarkRun& run : runs)
        summary.lower_bound = std::max(summary.lower_bound, run.spent.cost_lower_bound);
    return summary;
}

/// The summary of those runs of the planner in the direction which are on the problem, or on any;
/// none where there are no such runs.
std::optional<Summary> summary_of_row(const BenchmarkPlan& plan, std::span<const BenchmarkRun> runs,
                                      std::optional<std::size_t> problem, Direction direction,
                                      std::size_t planner) {
    std::vector<BenchmarkRun> row;
    for (const BenchmarkRun& run : runs)
        if (run.place.planner == planner && run.place.direction == direction &&
            (!problem || run.place.problem == *problem))
            row.push_back(run);
    if (row.empty()) return std::nullopt;
    Summary summary = summary_of(row, plan.time_limit);
    // Another program does not tell what it does inside.
    if (plan.planners[planner].external()) summary.nodes = summary.state_checks = {};
    return summary;
}

}  // namespace

std::vector<Summary> summarise(const BenchmarkPlan& plan, std::span<const BenchmarkRun> runs) {
    std::vector<Summary> summaries;
    for (std::size_t problem = 0; problem < plan.problems.size(); ++problem)
        for (const Direction direction : plan.directions)
            for (std::size_t planner = 0; planner < plan.planners.size(); ++planner)
                if (auto summary = summary_of_row(plan, runs, problem, direction, planner))
                    summaries.push_back(*std::move(summary));
    return summaries;
}

std::vector<Summary> summarise_over_problems(const BenchmarkPlan& plan,
                                             std::span<const BenchmarkRun> runs) {
    std::vector<Summary> summaries;
    for (const Direction direction : plan.directions)
        for (std::size_t planner = 0; planner < plan.planners.size(); ++planner)
            if (auto summary = summary_of_row(plan, runs, std::nullopt, direction, planner))
                summaries.push_back(*std::move(summary));
    return summaries;
}

std::size_t node_count(const BenchmarkRun& run) {
    return run.spent.tree_nodes[0] + run.spent.tree_nodes[1];
}

std::optional<double> cost_ratio(const BenchmarkRun& run) {
    const double bound = run.spent.cost_lower_bound;
    if (!run.solved() || !(bound > 0) || !std::isfinite(bound)) return std::nullopt;
    return run.spent.cost / bound;
}

}  // namespace asv::core
