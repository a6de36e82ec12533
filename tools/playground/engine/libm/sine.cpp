// std::sin and std::cos with the digits of pair.hpp.

#include <array>
#include <cmath>

#include "tools/playground/engine/libm/pair.hpp"

namespace asv::playground {

namespace {

/// Pieces of a full turn, and of a quarter.
constexpr int pieces = 64, quarter = 16;
/// Angles beyond this, in radians, are rare.
constexpr double greatest = 8;

const long double pi = 4 * std::atan(1.0L);

std::array<Pair, pieces> make_sines() {
    std::array<Pair, pieces> sines{};
    for (int i = 0; i < pieces; ++i)
        sines[static_cast<std::size_t>(i)] = pair_of(std::sin(2 * pi * i / pieces));
    return sines;
}

/// The sine of an angle that is turned by so many pieces: that of the nearest piece, and series for
/// what is left. Precondition: |angle| <= greatest.
double sine(double angle, int turned) {
    static const auto sines = make_sines();
    static const Pair piece = pair_of(2 * pi / pieces);
    const double nearest = std::round(angle / piece.high);
    const Pair near = plus_product(angle, -nearest, piece.high);
    const Pair left = sum(near.high, near.low - nearest * piece.low);
    const auto at = [&](int shift) {
        return sines[static_cast<std::size_t>((static_cast<int>(nearest) + shift) & (pieces - 1))];
    };
    const Pair s = at(turned), c = at(turned + quarter);
    // s cos(left) + c sin(left): the first terms of both series exactly, of which the others are a
    // thousandth.
    const double l = left.high;
    const Pair square = product(l, l);
    const double q = square.high;
    const double sine_rest =
        left.low + l * q * (-1.0 / 6 + q * (1.0 / 120 - q * (1.0 / 5040 - q / 362880)));
    const double cosine_rest = -0.5 * square.low + q * q * (1.0 / 24 - q * (1.0 / 720 - q / 40320));
    const Pair across = product(c.high, l), back = product(s.high, -0.5 * q);
    const Pair first = sum(s.high, across.high), total = sum(first.high, back.high);
    return total.high + (total.low + first.low + across.low + back.low + s.low + c.low * l +
                         c.high * sine_rest + s.high * cosine_rest);
}

}  // namespace

}  // namespace asv::playground

extern "C" double sin(double angle) {
    using namespace asv::playground;
    if (std::fabs(angle) <= greatest && std::fabs(angle) > 0x1p-20) return sine(angle, 0);
    return static_cast<double>(std::sin(static_cast<long double>(angle)));
}

extern "C" double cos(double angle) {
    using namespace asv::playground;
    if (std::fabs(angle) <= greatest) return sine(angle, quarter);
    return static_cast<double>(std::cos(static_cast<long double>(angle)));
}
