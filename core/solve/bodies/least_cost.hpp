#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/bounds/lower_bound.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// A path that costs no more than this has nothing left to gain: what every path costs that has no
/// use for the tolerance, and a share of 1e-5 more. 0 where nothing is known.
inline double nothing_to_gain_below(Problem problem, std::size_t effort = max_bound_effort) {
    constexpr double negligible = 1e-5;
    problem.requirements.tolerance = 0;
    const double bound = cost_lower_bound(problem, Reading::intended, effort).total;
    return std::isfinite(bound) ? bound * (1 + negligible) : 0;
}

/// The same for what a hundredth of the work (microseconds) may find, which is 0 in a large world.
inline double nothing_to_gain_below(const Problem& problem, double work) {
    constexpr double share = 0.01, for_each_obstacle = 10, for_each_cell = 0.5;
    const double left =
        share * work - for_each_obstacle * static_cast<double>(problem.obstacles.size());
    const double cells = std::min(left / for_each_cell, 1.0 * max_bound_effort);
    return cells < 1 ? 0 : nothing_to_gain_below(problem, static_cast<std::size_t>(cells));
}

}  // namespace asv::core
