#pragma once

#include "asv/geometry/primitives.hpp"

namespace asv::geometry {

/// Euclidean distance from the point to the closed box; 0 inside. Precondition: box is not empty.
double distance(const Point& point, const Box& box) noexcept;

/// Euclidean distance from the closed segment to the closed box; 0 exactly when they meet.
/// Precondition: box is not empty.
double distance(const Segment& segment, const Box& box) noexcept;

}  // namespace asv::geometry
