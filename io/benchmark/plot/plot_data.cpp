#include "io/benchmark/plot/plot_data.hpp"

#include <algorithm>

#include "core/benchmark/summary.hpp"
#include "io/benchmark/wording.hpp"

namespace asv::io {

namespace {

using core::BenchmarkRun;
using RunPointers = std::vector<const BenchmarkRun*>;

PlotSeries series_of(const RunPointers& runs, std::size_t planner, core::Direction direction,
                     bool relative) {
    PlotSeries series{planner, direction, 0, {}, {}};
    for (const BenchmarkRun* run : runs) {
        if (run->place.planner != planner || run->place.direction != direction) continue;
        ++series.runs;
        if (!run->solved()) continue;
        series.times.push_back(run->spent.time_to_first);
        series.costs.push_back(relative ? *core::cost_ratio(*run) : run->spent.cost);
    }
    std::sort(series.times.begin(), series.times.end());
    std::sort(series.costs.begin(), series.costs.end());
    return series;
}

void fill(PlotPanel& panel, const core::BenchmarkPlan& plan, const RunPointers& runs) {
    panel.relative = std::all_of(runs.begin(), runs.end(), [](const BenchmarkRun* run) {
        return !run->solved() || core::cost_ratio(*run);
    });
    for (std::size_t planner = 0; planner < plan.planners.size(); ++planner)
        for (const core::Direction direction : plan.directions) {
            PlotSeries series = series_of(runs, planner, direction, panel.relative);
            if (series.runs > 0) panel.series.push_back(std::move(series));
        }
}

double bound_of(const RunPointers& runs) {
    double bound = 0;
    for (const BenchmarkRun* run : runs) bound = std::max(bound, run->spent.cost_lower_bound);
    return bound;
}

}  // namespace

std::vector<PlotPanel> plot_panels(const BenchmarkReport& report, std::size_t most) {
    const core::BenchmarkPlan& plan = report.plan;
    std::vector<PlotPanel> panels;
    if (plan.problems.size() > most) {
        RunPointers all;
        for (const BenchmarkRun& run : report.runs) all.push_back(&run);
        panels.push_back(
            {"All " + std::to_string(plan.problems.size()) + " problems", {}, true, {}});
        fill(panels.back(), plan, all);
        return panels;
    }
    for (std::size_t problem = 0; problem < plan.problems.size(); ++problem) {
        RunPointers runs;
        for (const BenchmarkRun& run : report.runs)
            if (run.place.problem == problem) runs.push_back(&run);
        if (runs.empty()) continue;
        panels.push_back({plan.problems[problem].name,
                          problem_facts(plan.problems[problem].problem, bound_of(runs)),
                          true,
                          {}});
        fill(panels.back(), plan, runs);
    }
    return panels;
}

}  // namespace asv::io
