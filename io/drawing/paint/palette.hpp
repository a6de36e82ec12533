#pragma once

#include <cstdint>

namespace asv::io {

/// sRGB with opacity, each from 0 to 1.
struct Colour {
    double red = 0;
    double green = 0;
    double blue = 0;
    double alpha = 1;
    friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

/// 0x0072B2 is red 00, green 72, blue B2, opaque.
constexpr Colour rgb(std::uint32_t hex) {
    return {static_cast<double>((hex >> 16) & 0xFF) / 255,
            static_cast<double>((hex >> 8) & 0xFF) / 255, static_cast<double>(hex & 0xFF) / 255, 1};
}

constexpr Colour faded(Colour colour, double alpha) {
    colour.alpha = alpha;
    return colour;
}

/// The straight mixture in sRGB: a where share is 0, b where it is 1.
constexpr Colour mixed(const Colour& a, const Colour& b, double share) {
    return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share,
            a.blue + (b.blue - a.blue) * share, a.alpha + (b.alpha - a.alpha) * share};
}

enum class Theme { light, dark };

/// Colours by meaning. Start, goal and the mark of least clearance follow the hues of Okabe and
/// Ito (2008), which people with any colour vision can tell apart, at a lightness that has a
/// contrast of at least 4.5 on page and field (WCAG 2.1 AA); obstacles have at least 3, and the
/// ink at least 4.5 on them. A violation is red, and never marked by its colour alone. The player's
/// style sheet has the same colours.
struct Palette {
    Colour page;
    Colour field;
    Colour ink;
    Colour muted;
    Colour grid;
    Colour obstacle;
    Colour start;
    Colour goal;
    Colour least;
    Colour violation;
};

inline constexpr Palette light_palette{rgb(0xFFFFFF), rgb(0xF4F7FA), rgb(0x18242F), rgb(0x4A5A69),
                                       rgb(0xDDE4EA), rgb(0x808D9A), rgb(0x0068A8), rgb(0x007D57),
                                       rgb(0xA03A7C), rgb(0xC4161C)};

inline constexpr Palette dark_palette{rgb(0x0D1520), rgb(0x14202D), rgb(0xE8EEF4), rgb(0xA3B3C2),
                                      rgb(0x223244), rgb(0x5A6C7F), rgb(0x56B4E9), rgb(0x35C99B),
                                      rgb(0xE08FC0), rgb(0xFF7B6B)};

constexpr const Palette& palette(Theme theme) {
    return theme == Theme::light ? light_palette : dark_palette;
}

}  // namespace asv::io
