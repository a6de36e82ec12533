#pragma once

#include <cstddef>
#include <vector>

#include "core/model/problem.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// An obstacle, or the outside of the bounds beyond one of their sides.
struct Wall {
    Box whole;
    Box shrunk;  ///< so that no rounding makes it too large
};

/// What is missing for the numbers after a subtraction to be on the safe side of the exact ones.
double rounding_slack(const Requirements& requirements);

/// The bounds, moved outwards by slightly more than the tolerance.
Box widened_bounds(const Requirements& requirements);

/// The tolerance e, and half of the farthest that an ASV gets in a step. A straight move of length
/// d between two places outside of an obstacle that is shrunk by e keeps out of the obstacle shrunk
/// by d / 2 more, since whatever is inside that is farther than d / 2 from all places outside.
double shrink_for_steps(const Requirements& requirements);

/// Every side moved inwards by slightly more than `shrink`; nothing is left where low >= high.
Box shrunk(const Box& box, double shrink, const Requirements& requirements);

bool vanishes(const Box& box);

/// The outside of the bounds to the left, to the right, below and above them.
std::vector<Wall> outside(const Requirements& requirements);

}  // namespace asv::core
