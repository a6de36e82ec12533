#pragma once

#include "core/space/proof/line_motion.hpp"
#include "core/space/proof/obstacle_field.hpp"
#include "core/space/proof/proven_stretch.hpp"

namespace asv::core {

/// Shortens the stretch to how far around the moment no broom is proven to meet an obstacle, by the
/// gap along a fixed axis that separates the two, so that sliding along a wall costs next to
/// nothing. False where one meets at the moment. rounding: a gap that is no greater is none.
bool prove_collisions(const LineMotion& motion, const ObstacleField& field, double rounding,
                      ProvenStretch& stretch);

}  // namespace asv::core
