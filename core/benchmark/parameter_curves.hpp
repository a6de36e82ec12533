#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/benchmark/run.hpp"
#include "core/benchmark/statistics/statistics.hpp"

/// How planners do over a parameter of the problems: the number of ASVs, the height of a corridor.

namespace asv::core {

/// "n" is the number of ASVs (points of any body), "obstacles" that of the obstacles; any other
/// name is looked for among the parameters of the problem. None where there is no such thing.
std::optional<double> parameter_of(const BenchmarkProblem& problem, std::string_view name);

/// One planner on all problems that have one value of the parameter, in all directions and with all
/// seeds.
struct ParameterPoint {
    double value = 0;  ///< of the parameter
    std::size_t runs = 0, solved = 0;
    statistics::Interval success;  ///< confidence interval of the rate of solved runs, 0 to 1
    /// Seconds to the first path, a run that is not solved censored at the time limit.
    statistics::CensoredValue median_time;
    statistics::CensoredInterval median_interval;  ///< its confidence interval
};

struct ParameterCurve {
    std::size_t planner = 0;             ///< index into the plan
    std::vector<ParameterPoint> points;  ///< by value, ascending
};

/// One for each planner that has runs on problems with the parameter; others are left out.
std::vector<ParameterCurve> parameter_curves(const BenchmarkPlan& plan,
                                             std::span<const BenchmarkRun> runs,
                                             std::string_view name);

}  // namespace asv::core
