#pragma once

#include <limits>

#include "geometry/primitives.hpp"

namespace asv::geometry {

inline constexpr Box unit{{0, 0}, {1, 1}};
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace asv::geometry
