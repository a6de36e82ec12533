#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::core {

/// How far a line is proven valid before and after a moment, in its parameter; negative: it is
/// invalid at the moment.
struct ProvenStretch {
    double back, ahead;

    /// Shortens the stretch to where gap + slope s - curvature s^2 / 2 may become negative, s from
    /// the moment on; false if the gap is negative, or is no number.
    bool limit(double gap, double slope, double curvature) {
        if (!(gap >= 0)) return false;
        const double farther = std::max(back, ahead);
        if (gap >= (std::abs(slope) + 0.5 * curvature * farther) * farther) return true;
        const double root = std::sqrt(slope * slope + 2 * curvature * gap);
        // The positive zero, in the form that does not cancel.
        const auto zero = [&](double s) {
            if (s < 0) return 2 * gap / (root - s);
            return curvature > 0 ? (root + s) / curvature : std::numeric_limits<double>::infinity();
        };
        ahead = std::min(ahead, zero(slope));
        back = std::min(back, zero(-slope));
        return true;
    }
};

}  // namespace asv::core
