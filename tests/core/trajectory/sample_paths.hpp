#pragma once

#include <cstddef>

#include "core/model/path.hpp"
#include "tests/kit/chains/chains.hpp"
#include "tests/kit/random.hpp"

/// Paths of vehicles that no brooms join, for trajectories.

namespace asv::test {

/// So many vehicles side by side along the x axis.
core::Path straight_run(std::size_t vehicles, std::size_t steps, double step);

/// The path with one more vehicle, which does not move.
core::Path beside_a_resting_one(const core::Path& path);

/// One vehicle once around a circle.
core::Path circle(double radius, std::size_t steps);

/// One vehicle, so many steps along x and as many along y.
core::Path around_a_corner(std::size_t steps, double step);

/// Vehicles that turn by little from step to step, each step 0.001 long or shorter.
core::Path winding_path(Random& random, std::size_t vehicles, std::size_t steps);

/// Vehicles that turn as they like, with steps of all sizes, some of which are none.
core::Path wild_path(Random& random, std::size_t vehicles, std::size_t steps);

core::Path reversed(const core::Path& path);

}  // namespace asv::test
