#pragma once

#include <vector>

#include "core/model/requirements.hpp"
#include "core/validation/finding.hpp"
#include "core/validation/motion/quadratic.hpp"
#include "core/validation/state_checks.hpp"

/// The requirements on the shape of the chain at every time of a straight motion between two
/// states. Each holds only when it is proven: the polynomials that decide it are compared with
/// their limits plus what rounding may have done, so a motion that stays clear of a limit by less
/// than that (some 1e-14) counts as a violation. Offenders carry the time of the least room.
/// Precondition of all: at least one ASV, finite coordinates.

namespace asv::core::validation {

/// The positions of ASV 1 to n.
using Motion = std::vector<Moving>;

/// The squared length is a quadratic of the time. Between two states of the right length it dips
/// when the broom turns: a turn by 0.04, the most that steps of 0.001 allow, costs 1.0e-5.
Finding check_motion_broom_lengths(const Motion& motion, const Requirements& requirements);

/// No turn goes against the orientation by more than the tolerance, none reaches pi, their sum
/// stays, and the closing side does not shrink to a point, where its direction would jump. The room
/// of turns that leave more than `radius` is not measured.
Finding check_motion_convexity(const Motion& motion, const Requirements& requirements,
                               double radius);

/// The area is a quadratic of the time.
Finding check_motion_area(const Motion& motion, const Requirements& requirements);

/// The bounds are convex: a straight motion between two points inside stays inside.
Finding check_motion_bounds(State from, State to, const Requirements& requirements);

}  // namespace asv::core::validation
