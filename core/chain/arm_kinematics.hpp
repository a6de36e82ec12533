#pragma once

#include <span>
#include <vector>

#include "core/model/body.hpp"
#include "geometry/primitives.hpp"

/// The kinematics of an arm: joint angles to the configurations of its Chain, and to points.

namespace asv::core {

/// Fills a configuration of the arm's Chain (anchored at its first point: base, heading of the
/// first link, turns). Linear in the angles, so that a straight line stays one. Precondition: one
/// angle for each link, radians; row has two numbers more.
void arm_configuration(const PlanarArm& arm, const geometry::Point& base,
                       std::span<const double> angles, std::span<double> row);

/// The base, the joints and the tip: one point more than there are links.
std::vector<geometry::Point> arm_points(const PlanarArm& arm, const geometry::Point& base,
                                        std::span<const double> angles);

}  // namespace asv::core
