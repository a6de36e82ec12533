#pragma once

#include <span>

#include "geometry/primitives.hpp"

namespace asv::geometry {

/// Signed area of the closed polygon by the shoelace formula, positive when counter-clockwise;
/// 0 for fewer than three vertices. Computed relative to the first vertex, in double precision.
double signed_area(std::span<const Point> polygon) noexcept;

/// Exact: +1 when the closed polygon is convex and counter-clockwise, -1 convex and clockwise,
/// 0 otherwise (reflex vertex, several windings, all points collinear). Straight vertices and
/// repeated points are allowed.
int convex_orientation(std::span<const Point> polygon);

}  // namespace asv::geometry
