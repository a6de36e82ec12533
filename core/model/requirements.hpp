#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "geometry/primitives.hpp"

namespace asv::core {

/// What every primitive step has to meet, all lengths in workspace units. The numbers are those of
/// the public assignment; every tolerance of the program comes from here.
struct Requirements {
    double broom_length = 0.05;            ///< distance of neighbouring ASVs
    double max_step = 0.001;               ///< farthest any ASV may move in one primitive step
    double area_radius_per_broom = 0.007;  ///< r of the minimum area pi * r^2, for each broom
    geometry::Box bounds{{0, 0}, {1, 1}};  ///< where the ASVs may be; see without_bounds()
    double tolerance = 1e-5;  ///< e: how far a verdict is lenient, in every requirement

    /// Is there an end to where the ASVs may be?
    bool bounded() const { return std::isfinite(bounds.low.x); }

    /// pi * (0.007 * (n - 1))^2: the least area of the closed polygon of n ASVs.
    double min_area(std::size_t asv_count) const {
        const double radius =
            asv_count == 0 ? 0 : area_radius_per_broom * static_cast<double>(asv_count - 1);
        return std::numbers::pi * radius * radius;
    }
};

/// The bounds of an endless plane.
inline geometry::Box without_bounds() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {{-infinity, -infinity}, {infinity, infinity}};
}

}  // namespace asv::core
