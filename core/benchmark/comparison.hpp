#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/benchmark/run.hpp"
#include "core/benchmark/statistics/statistics.hpp"

/// Planners compared in pairs, over all problems that both have run on.

namespace asv::core {

enum class Measure {
    time,  ///< seconds to the first path, at most the time limit: a run that is not solved has that
    cost   ///< of the path, where both runs of a pair are solved
};

/// Two planners by one measure. A pair is a run of each on the same problem in the same direction
/// with the same seed; a task is a problem in one direction.
struct Comparison {
    Measure measure = Measure::time;
    std::size_t first = 0, second = 0;  ///< planners of the plan, first < second
    /// Of the logarithms of first / second: a task of long times weighs no more than one of short
    /// ones. It asks whether the planners differ on these tasks, not on others.
    statistics::SignedRank test = {};
    double corrected_p = 1;  ///< for the number of all comparisons of the benchmark
    double ratio = 1;        ///< the median of first / second
    statistics::Interval ratio_interval = {};  ///< its confidence interval
    /// A12, the chance that a run of the first is better than one of the second on the same task:
    /// the mean over the tasks.
    double chance_of_less = 0.5;
    std::size_t first_better = 0, second_better = 0;  ///< tasks with the lesser median
};

/// Every two planners of the plan by time, then by cost; two that have no pair are left out.
std::vector<Comparison> compare_planners(const BenchmarkPlan& plan,
                                         std::span<const BenchmarkRun> runs);

}  // namespace asv::core
