#pragma once

#include <span>

#include "core/model/problem.hpp"
#include "geometry/free_plane/free_plane.hpp"

namespace asv::core {

/// What counts as a path, where the tolerance leaves a choice.
enum class Reading {
    /// What the requirements mean: the chain moves continuously, and obstacles that touch each
    /// other or the border, or are at most the tolerance apart, leave no way between them.
    intended,
    /// Whatever the validator accepts without certifying the motion between the primitive steps:
    /// a chain may jump over the corner of an obstacle, as far as one step reaches, and squeeze
    /// through between obstacles that touch, in the gap of two tolerances that shrinking them
    /// opens. (Long chains can: seven ASVs get through between two boxes 0.1 thick.)
    literal
};

/// Where each ASV of the problem's chain can be: no path of any of them leaves this free space, or
/// it can be replaced there by one that is not longer. For start and goal likewise, up to the
/// tolerance in their positions.
///
/// With two or more ASVs, each is an end of a broom, hence never in an obstacle shrunk by the
/// tolerance e, and a straight move of length d between two such places keeps out of the obstacle
/// shrunk by d / 2 more (see shrink_for_steps). By the reading, d is the distance from the given
/// start to the first state, at most e, or that and each primitive step, at most 0.001 + e. A
/// single ASV has no broom and meets nothing; a point keeps out of the obstacles like the end of a
/// broom. Not for arms.
///
/// Seams between obstacles are closed as the reading says, `literal` only those through which no
/// chain can pass (is_impassable), and never those in which a broom of the start or goal lies.
/// The boxes of `closed` are obstacles as well, as they are.
/// Precondition: start and goal are valid states.
geometry::FreePlane make_asv_plane(const Problem& problem, Reading reading,
                                   std::span<const Box> closed = {});

/// Where the middle of the chain can be, in the literal reading. It is on a broom, so that it meets
/// what an ASV meets; but no seam is closed, since the proofs of seams speak of ASVs. The boxes of
/// `closed` are obstacles as well, as they are. Preconditions: as above, and bounds.
geometry::FreePlane make_middle_plane(const Problem& problem, std::span<const Box> closed = {});

}  // namespace asv::core
