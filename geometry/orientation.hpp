#pragma once

#include "asv/geometry/primitives.hpp"

namespace asv::geometry {

/// Exact sign of the area of the triangle a, b, c: +1 counter-clockwise, -1 clockwise, 0 collinear
/// (also when points coincide). Precondition: finite coordinates.
int orientation(const Point& a, const Point& b, const Point& c) noexcept;

}  // namespace asv::geometry
