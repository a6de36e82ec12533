#pragma once

#include "core/search/search_result.hpp"
#include "core/space/joint_world.hpp"

namespace asv::core {

/// The shortest path of a point, start, bends and goal, that keeps the planner's margins to
/// obstacles and bounds (JointWorld::constraints), each motion proven. Empty where the margins
/// leave no way, or where so many obstacles are in the way that finding it takes more than half a
/// second or so; then a planner has to search. The method is that of geometry::FreePlane, which is
/// exact. Precondition: the body is a point.
Configurations point_geodesic(const JointWorld& world);

}  // namespace asv::core
