#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "core/search/trees/nearest.hpp"

namespace asv::core {

/// The row turned by full turns of its angles until each is nearest to that of the other row.
inline void unwrap(std::span<double> row, std::span<const double> other, WrappingAngles angles) {
    constexpr double full = 2 * std::numbers::pi;
    for (std::size_t i = angles.first; i < angles.first + angles.count; ++i)
        row[i] -= full * std::round((row[i] - other[i]) / full);
}

/// out = from + t * (to - from) along the straight motion. Precondition: from and to are unwrapped
/// alike. out may be either of them.
inline void interpolate(std::span<const double> from, std::span<const double> to, double t,
                        std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = from[i] + t * (to[i] - from[i]);
}

/// The distance in the metric of a space by the shorter way round of every angle.
template <class Space>
double distance_between(Space& space, std::span<const double> a, std::span<const double> b) {
    const WrappingAngles angles = space.wrapping();
    if (angles.count == 0) return space.distance(a, b);
    std::vector<double> unwrapped(b.begin(), b.end());
    unwrap(unwrapped, a, angles);
    return space.distance(a, unwrapped);
}

}  // namespace asv::core
