#pragma once

#include <span>
#include <vector>

#include "core/model/problem.hpp"
#include "core/search/rng.hpp"
#include "tests/kit/chains/chains.hpp"

/// Random planar arms, and where they are by the textbook.

namespace asv::test {

/// One to six links between random angles, some joints with limits.
core::PlanarArm random_arm(core::Rng& rng);

/// The points by the textbook and the C library.
Points textbook(const core::PlanarArm& arm, const Point& base, std::span<const double> angles);

/// Does a link, or a single point, meet one of the closed boxes?
bool collides(const Points& points, const std::vector<geometry::Box>& boxes);

/// A random arm among boxes that its start and goal do not meet.
core::Problem arm_problem(core::Rng& rng);

}  // namespace asv::test
