#pragma once

#include <cstddef>
#include <vector>

#include "core/bounds/asv_plane.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// What every solution costs at least.
struct CostLowerBound {
    double total = 0;             ///< of the sum over all ASVs
    std::vector<double> lengths;  ///< of the way of each ASV, or of an arm; their sum is the total
};

/// Cells that the searches of all ASVs together may enter: about half a second.
inline constexpr std::size_t max_bound_effort = 1'000'000;

/// No solution has fewer primitive steps than this, if none of them uses the tolerance of the step
/// length: as many as the ASV with the longest way needs. 0 where no ASV moves freely (arms).
std::size_t steps_lower_bound(const Problem& problem, const CostLowerBound& bound);

/// A lower bound of the cost of every path from the start to the goal: the sum of the shortest
/// paths that each ASV would have on its own in the free space of make_asv_plane, less what the
/// tolerance allows at both ends. Infinity where an ASV's start and goal are not connected in it.
///
/// For an arm it is the straight way in the space of its joint angles, whatever the obstacles.
///
/// Proven, in each reading, for the true cost of every path that the reading admits; the cost that
/// a file states may differ from that by the tolerance. In a crowd of very many boxes, where the
/// searches would enter more cells than `effort`, the bound is smaller than the sum.
/// Precondition: start and goal are valid states.
CostLowerBound cost_lower_bound(const Problem& problem, Reading reading = Reading::intended,
                                std::size_t effort = max_bound_effort);

}  // namespace asv::core
