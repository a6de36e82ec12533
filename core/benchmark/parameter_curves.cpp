#include "core/benchmark/parameter_curves.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace asv::core {

namespace {

ParameterPoint point_of(double value, statistics::CensoredSample times) {
    std::sort(times.known.begin(), times.known.end());
    ParameterPoint point;
    point.value = value;
    point.runs = times.size();
    point.solved = times.known.size();
    point.success = statistics::success_interval(point.solved, point.runs);
    point.median_time = statistics::quantile(times, 0.5);
    point.median_interval = statistics::median_interval(times);
    return point;
}

}  // namespace

std::optional<double> parameter_of(const BenchmarkProblem& problem, std::string_view name) {
    if (name == "n") return static_cast<double>(problem.problem.asv_count());
    if (name == "obstacles") return static_cast<double>(problem.problem.obstacles.size());
    const auto found = std::find_if(problem.parameters.begin(), problem.parameters.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    if (found == problem.parameters.end()) return std::nullopt;
    return found->second;
}

std::vector<ParameterCurve> parameter_curves(const BenchmarkPlan& plan,
                                             std::span<const BenchmarkRun> runs,
                                             std::string_view name) {
    std::map<std::size_t, std::map<double, statistics::CensoredSample>> times;
    for (const BenchmarkRun& run : runs) {
        const auto value = parameter_of(plan.problems[run.place.problem], name);
        if (!value) continue;
        statistics::CensoredSample& sample = times[run.place.planner][*value];
        sample.limit = plan.time_limit;
        if (run.solved())
            sample.known.push_back(run.spent.time_to_first);
        else
            ++sample.censored;
    }
    std::vector<ParameterCurve> curves;
    for (auto& [planner, samples] : times) {
        curves.push_back({planner, {}});
        for (auto& [value, sample] : samples)
            curves.back().points.push_back(point_of(value, std::move(sample)));
    }
    return curves;
}

}  // namespace asv::core
