#pragma once

#include <cstddef>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"

namespace asv::test {

/// A wall 0.1 thick right across the square, from two boxes that touch at y = 0.5; the upper one
/// ends at `top`, so that there is a door above it when top < 1. The chain stands in an L to the
/// left of the place where the boxes touch, and shall get to an L on the right.
core::Problem wall_of_two(std::size_t asv_count, double top);

/// A path of seven ASVs along the line on which the boxes of wall_of_two touch.
core::Solution squeeze_through(const core::Problem& problem);

}  // namespace asv::test
