#include "core/benchmark/curves.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/benchmark/summary.hpp"

namespace asv::core {

namespace {

using Task = std::pair<std::size_t, Direction>;

Task task_of(const Summary& summary) {
    return {summary.problem, summary.direction};
}

/// Seconds; none where it is beyond the time limit.
std::optional<double> median_time(const Summary& summary) {
    // No clock tells less; a factor of nothing would be no number.
    constexpr double least = 1e-9;
    const auto median = statistics::quantile(summary.time_to_solution, 0.5);
    if (median.censored) return std::nullopt;
    return std::max(least, median.value);
}

std::map<Task, double> least_medians(std::span<const Summary> summaries) {
    std::map<Task, double> least;
    for (const Summary& summary : summaries)
        if (const std::optional<double> median = median_time(summary)) {
            const auto [entry, first] = least.try_emplace(task_of(summary), *median);
            if (!first) entry->second = std::min(entry->second, *median);
        }
    return least;
}

/// Of the best path that the run had at this time; none before its first path.
std::optional<double> cost_at(const BenchmarkRun& run, double time) {
    if (!run.solved()) return std::nullopt;
    const auto& history = run.spent.cost_history;
    const auto later = std::find_if(history.begin(), history.end(),
                                    [&](const auto& entry) { return entry.first > time; });
    if (later == history.begin()) return std::nullopt;
    return std::prev(later)->second;
}

}  // namespace

std::vector<PerformanceProfile> performance_profiles(const BenchmarkPlan& plan,
                                                     std::span<const BenchmarkRun> runs) {
    const std::vector<Summary> summaries = summarise(plan, runs);
    const std::map<Task, double> least = least_medians(summaries);
    std::vector<PerformanceProfile> profiles;
    for (std::size_t planner = 0; planner < plan.planners.size(); ++planner) {
        PerformanceProfile profile{planner, 0, {}};
        for (const Summary& summary : summaries) {
            if (summary.planner != planner) continue;
            ++profile.tasks;
            if (const std::optional<double> median = median_time(summary))
                profile.factors.push_back(*median / least.at(task_of(summary)));
        }
        std::sort(profile.factors.begin(), profile.factors.end());
        if (profile.tasks > 0) profiles.push_back(std::move(profile));
    }
    return profiles;
}

std::vector<CostQuartiles> cost_over_time(std::span<const BenchmarkRun> runs,
                                          std::span<const double> times) {
    std::vector<CostQuartiles> quartiles;
    for (const double time : times) {
        statistics::CensoredSample costs;
        for (const BenchmarkRun& run : runs) {
            if (const std::optional<double> cost = cost_at(run, time))
                costs.known.push_back(*cost);
            else
                ++costs.censored;
        }
        std::sort(costs.known.begin(), costs.known.end());
        quartiles.push_back({statistics::quantile(costs, 0.25), statistics::quantile(costs, 0.5),
                             statistics::quantile(costs, 0.75)});
    }
    return quartiles;
}

}  // namespace asv::core
