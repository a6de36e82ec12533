#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/benchmark/run.hpp"
#include "core/benchmark/statistics/statistics.hpp"

/// What many runs have in common: the figures of a table.

namespace asv::core {

/// One planner in one direction, all seeds, on one problem or on several. What a run costs and
/// spends is told of the solved ones alone, the time to a solution of all of them.
struct Summary {
    std::size_t problem = 0, planner = 0;  ///< indices into the plan; of several problems the first
    Direction direction = Direction::forward;
    std::size_t runs = 0, solved = 0;
    std::size_t invalid = 0;       ///< runs whose path violates a requirement
    statistics::Interval success;  ///< confidence interval of the rate of solved runs, 0 to 1
    /// Seconds to the first path; a run that is not solved, for whatever reason, is censored at
    /// the time limit.
    statistics::CensoredSample time_to_solution;
    statistics::CensoredInterval median_time;  ///< confidence interval of its median, seconds
    statistics::Spread time_to_first;          ///< seconds, of the solved runs alone
    statistics::Spread nodes;                  ///< of all trees
    statistics::Spread state_checks;
    statistics::Spread cost_first, cost;
    statistics::Interval median_cost;  ///< confidence interval of the median; 0 without any
    statistics::Spread ratio;          ///< of the cost to the lower bound, where that is known
    double lower_bound = 0;            ///< of the cost; 0 where it is not known
};

/// One for each problem, direction and planner of the plan that has runs, in that order.
std::vector<Summary> summarise(const BenchmarkPlan& plan, std::span<const BenchmarkRun> runs);

/// One for each direction and planner of the plan that has runs, in that order, of its runs on all
/// problems. Costs of unlike problems have no median worth telling; their ratios have.
std::vector<Summary> summarise_over_problems(const BenchmarkPlan& plan,
                                             std::span<const BenchmarkRun> runs);

/// Nodes of all trees of the run.
std::size_t node_count(const BenchmarkRun& run);

/// Its cost over the lower bound; none when it is not solved or the bound is not known.
std::optional<double> cost_ratio(const BenchmarkRun& run);

}  // namespace asv::core
