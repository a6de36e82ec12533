#pragma once

#include <vector>

#include "core/model/path.hpp"
#include "core/model/requirements.hpp"
#include "core/validation/collisions.hpp"

namespace asv::core::validation {

/// Certifies that every state of the straight-line motion of each ASV between consecutive states
/// meets the requirements with their tolerance: broom lengths, convexity, area, bounds,
/// collisions, in this order. What cannot be proven counts as violated. Coordinates that are not
/// finite fail both steps that they belong to. O(steps * (n + log m)).
std::vector<CheckResult> certify_motion(const Path& path, const Requirements& requirements,
                                        const Obstacles& obstacles, bool list_offenders);

}  // namespace asv::core::validation
