#pragma once

#include <optional>
#include <string>

#include "geometry/primitives.hpp"

namespace asv::io {

/// Why an obstacle hinders nobody, in words: "is 0 wide, less than twice the tolerance of 1e-05,
/// and vanishes". Obstacles count less the tolerance on each side, so nothing is left of one that
/// is thinner than that; none for one of which something is left.
std::optional<std::string> why_it_vanishes(const geometry::Box& obstacle, double tolerance);

}  // namespace asv::io
