#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/model/requirements.hpp"
#include "core/validation/finding.hpp"
#include "geometry/primitives.hpp"

/// The requirements on one state alone, each with the arithmetic of the reference tester, so that
/// verdicts agree to the last digit. Precondition of all: at least one ASV, finite coordinates.

namespace asv::core::validation {

using State = std::span<const geometry::Point>;

/// The first ASV whose position is not finite, as a violation of whatever is checked, if any.
std::optional<Finding> find_not_finite(State state);
/// Likewise of a step, from its first state on.
std::optional<Finding> find_not_finite(State from, State to);

/// The distance of neighbouring ASVs is within the tolerance of the broom length. Room: length.
Finding check_broom_lengths(State state, const Requirements& requirements);

/// One side of a state, from point i to the next: its distance is within the tolerance of length.
/// Takes the place of `worst` where it is worse.
void check_side_length(State state, std::size_t i, double length, double tolerance, Finding& worst);

/// The closed polygon of the ASVs turns one way. Room: radians, to a turn against the others
/// beyond the tolerance, to a turn of pi, or of the sum of all turns to 3 pi (then without an ASV).
Finding check_convexity(State state, const Requirements& requirements);

/// The closed polygon is large enough. Room: area.
Finding check_area(State state, const Requirements& requirements);

/// Every ASV is in the bounds, the upper ones excluded. Room: length to the nearest side.
Finding check_bounds(State state, const Requirements& requirements);

/// Euclidean distance as the reference tester computes it.
double distance(const geometry::Point& a, const geometry::Point& b);

}  // namespace asv::core::validation
