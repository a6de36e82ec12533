#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/benchmark/run.hpp"

/// What many runs have in common: the figures of a table.

namespace asv::core {

/// The quantile of values in ascending order, between two of them linearly (type 7 of Hyndman and
/// Fan, 1996): 0 is the least, 0.5 the median, 1 the greatest. Precondition: not empty, 0 <= share
/// <= 1.
double quantile(std::span<const double> ascending, double share);

/// Of some values; all 0 without any.
struct Spread {
    std::size_t count = 0;
    double least = 0, median = 0, greatest = 0;
    double mean = 0;
    double deviation = 0;  ///< of the sample (n - 1); 0 for a single value
};

Spread spread_of(std::vector<double> values);

/// One planner on one problem in one direction, all seeds. Everything but the numbers of runs is
/// of the solved ones alone.
struct Summary {
    std::size_t problem = 0, planner = 0;  ///< indices into the plan
    Direction direction = Direction::forward;
    std::size_t runs = 0, solved = 0;
    Spread time_to_first;  ///< seconds
    Spread nodes;          ///< of all trees
    Spread state_checks;
    Spread cost_first, cost;
    Spread ratio;            ///< of the cost to the lower bound, where that is known
    double lower_bound = 0;  ///< of the cost; 0 where it is not known
};

/// One for each problem, direction and planner of the plan that has runs, in that order.
std::vector<Summary> summarise(const BenchmarkPlan& plan, std::span<const BenchmarkRun> runs);

/// Nodes of all trees of the run.
std::size_t node_count(const BenchmarkRun& run);

/// Its cost over the lower bound; none when it is not solved or the bound is not known.
std::optional<double> cost_ratio(const BenchmarkRun& run);

}  // namespace asv::core
