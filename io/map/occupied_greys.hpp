#pragma once

namespace asv::io {

/// The greys of a picture that are occupied, both ends included: 0 is black, 255 is white.
struct OccupiedGreys {
    double darkest = 0;
    double brightest = 127;

    /// white: what the value of white is in the scale of the grey, as a multiple of 255.
    bool hold(double grey, double white = 1) const {
        return grey >= darkest * white && grey <= brightest * white;
    }
};

}  // namespace asv::io
