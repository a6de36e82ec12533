#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/benchmark/run.hpp"
#include "core/benchmark/statistics/statistics.hpp"

/// What many runs look like as curves.

namespace asv::core {

/// The performance profile of a planner (Dolan and Moré, 2002): on which share of the tasks its
/// median time to the first path is within a factor of the least median of any planner. A task is a
/// problem in one direction.
struct PerformanceProfile {
    std::size_t planner = 0;      ///< index into the plan
    std::size_t tasks = 0;        ///< on which it ran
    std::vector<double> factors;  ///< 1 or more, ascending: of the tasks that it solves by median
};

/// One for each planner that has runs. A planner whose median is beyond the time limit is within no
/// factor.
std::vector<PerformanceProfile> performance_profiles(const BenchmarkPlan& plan,
                                                     std::span<const BenchmarkRun> runs);

/// The quartiles of the cost of the best path so far. A run without a path counts as one of
/// greater cost than any other: what it has a part in is censored, of no value.
struct CostQuartiles {
    statistics::CensoredValue lower, median, upper;
};

/// Of runs of one task at each of the times, seconds since the begin of each run. Precondition:
/// there are runs.
std::vector<CostQuartiles> cost_over_time(std::span<const BenchmarkRun> runs,
                                          std::span<const double> times);

}  // namespace asv::core
