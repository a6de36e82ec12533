#pragma once

#include "core/model/problem.hpp"

namespace asv::test {

/// The doors in the wall of two_doors(): as wide as high, 0.1 and 0.15.
inline constexpr geometry::Box near_door{{0.5, 0.3}, {0.6, 0.4}}, far_door{{0.5, 0.75}, {0.6, 0.9}};

/// Three ASVs on the left of a wall that shall get to its right; the way through the lower door is
/// the shorter one.
core::Problem two_doors();

}  // namespace asv::test
