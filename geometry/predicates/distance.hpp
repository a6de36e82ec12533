#pragma once

#include "geometry/primitives.hpp"

/// Distances in double precision. With D the largest difference of coordinates among the two
/// arguments and 1e-150 < D < 1e150, the absolute error is below 4e-15 * D; a certificate that
/// needs a lower bound subtracts that. Whether a distance is zero is exact for all magnitudes.

namespace asv::geometry {

/// Euclidean distance from the point to the closed box; 0 exactly when the box holds the point.
/// Preconditions: finite coordinates, box is not empty.
double distance(const Point& point, const Box& box) noexcept;

/// Euclidean distance from the closed segment to the closed box; 0 exactly when they meet.
/// Preconditions: finite coordinates, box is not empty.
double distance(const Segment& segment, const Box& box) noexcept;

}  // namespace asv::geometry
