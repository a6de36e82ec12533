#pragma once

#include <limits>

#include "geometry/primitives.hpp"

namespace asv::geometry {

/// Exact sign of the area of the triangle a, b, c: +1 counter-clockwise, -1 clockwise, 0 collinear
/// (also when points coincide). Precondition: finite coordinates.
int orientation(const Point& a, const Point& b, const Point& c) noexcept;

/// When the floating-point determinant of orientation decides: its magnitude has to exceed
/// relative * (sum of the magnitudes of its two products) + absolute. Derived in orientation.cpp.
struct OrientationFilter {
    double relative, absolute;
};
inline constexpr double unit_roundoff = 0x1p-53;
inline constexpr OrientationFilter orientation_filter{(3 + 16 * unit_roundoff) * unit_roundoff,
                                                      std::numeric_limits<double>::min()};

}  // namespace asv::geometry
