#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "io/drawing/paint/palette.hpp"

namespace asv::io {

/// "#0072b2", as style sheets have it; the opacity is left out.
inline std::string colour_text(const Colour& colour) {
    const auto byte = [](double share) { return static_cast<int>(std::lround(255 * share)); };
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(colour.red), byte(colour.green),
                  byte(colour.blue));
    return text.data();
}

}  // namespace asv::io
