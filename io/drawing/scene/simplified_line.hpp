#pragma once

#include <vector>

#include "geometry/primitives.hpp"

namespace asv::io {

/// The line without the points that lie nearer to it than the distance (Douglas and Peucker 1973).
std::vector<geometry::Point> simplified(const std::vector<geometry::Point>& points,
                                        double distance);

}  // namespace asv::io
