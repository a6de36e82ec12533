#include "core/benchmark/summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace asv::core {

namespace {

template <class Value>
Spread spread_over(std::span<const BenchmarkRun> runs, const Value& value) {
    std::vector<double> values;
    for (const BenchmarkRun& run : runs)
        if (run.solved())
            if (const std::optional<double> found = value(run)) values.push_back(*found);
    return spread_of(std::move(values));
}

Summary summary_of(std::span<const BenchmarkRun> runs) {
    const auto over = [&](auto value) {
        return spread_over(runs, [&](const BenchmarkRun& run) -> std::optional<double> {
            return static_cast<double>(std::invoke(value, run));
        });
    };
    Summary summary;
    summary.problem = runs[0].place.problem;
    summary.planner = runs[0].place.planner;
    summary.direction = runs[0].place.direction;
    summary.runs = runs.size();
    summary.time_to_first = over([](const BenchmarkRun& run) { return run.spent.time_to_first; });
    summary.solved = summary.time_to_first.count;
    summary.nodes = over(node_count);
    summary.state_checks = over([](const BenchmarkRun& run) { return run.spent.state_checks; });
    summary.cost_first = over([](const BenchmarkRun& run) { return run.spent.cost_first; });
    summary.cost = over([](const BenchmarkRun& run) { return run.spent.cost; });
    summary.ratio = spread_over(runs, cost_ratio);
    for (const BenchmarkRun& run : runs)
        summary.lower_bound = std::max(summary.lower_bound, run.spent.cost_lower_bound);
    return summary;
}

bool of_one_row(const RunPlace& a, const RunPlace& b) {
    return a.problem == b.problem && a.planner == b.planner && a.direction == b.direction;
}

}  // namespace

double quantile(std::span<const double> ascending, double share) {
    const double place = share * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    return std::lerp(ascending[below], ascending[above], place - static_cast<double>(below));
}

Spread spread_of(std::vector<double> values) {
    Spread spread;
    spread.count = values.size();
    if (values.empty()) return spread;
    std::sort(values.begin(), values.end());
    spread.least = values.front();
    spread.median = quantile(values, 0.5);
    spread.greatest = values.back();
    const auto count = static_cast<double>(values.size());
    for (const double value : values) spread.mean += value / count;
    double squares = 0;
    for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
    if (values.size() > 1) spread.deviation = std::sqrt(squares / (count - 1));
    return spread;
}

std::vector<Summary> summarise(const BenchmarkPlan& plan, std::span<const BenchmarkRun> runs) {
    std::vector<Summary> summaries;
    for (std::size_t problem = 0; problem < plan.problems.size(); ++problem)
        for (const Direction direction : plan.directions)
            for (std::size_t planner = 0; planner < plan.planners.size(); ++planner) {
                std::vector<BenchmarkRun> row;
                for (const BenchmarkRun& run : runs)
                    if (of_one_row(run.place, {problem, planner, direction, 0})) row.push_back(run);
                if (!row.empty()) summaries.push_back(summary_of(row));
            }
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
