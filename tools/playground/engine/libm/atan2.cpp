// std::atan2 with the digits of pair.hpp.

#include <array>
#include <cmath>
#include <utility>

#include "tools/playground/engine/libm/pair.hpp"

namespace asv::playground {

namespace {

constexpr std::size_t pieces = 32;

/// The angles whose tangents are 0, 1/32, ..., 1.
std::array<Pair, pieces + 1> make_angles() {
    std::array<Pair, pieces + 1> angles{};
    for (std::size_t i = 0; i <= pieces; ++i)
        angles[i] = pair_of(std::atan(static_cast<long double>(i) / pieces));
    return angles;
}

/// Of a point in the first octant: the nearest of the angles above, and a series for what is left.
Pair in_first_octant(double x, double y) {
    static const auto angles = make_angles();
    const double nearest = std::round(pieces * (y / x));
    const double tangent = nearest / pieces;
    // The tangent of what is left is (y - tangent x) / (x + tangent y).
    const Pair across = plus_product(y, -tangent, x), along = plus_product(x, tangent, y);
    const double left = (across.high + across.low) / along.high;
    const Pair back = product(left, along.high);
    const double rest =
        (((across.high - back.high) - back.low) + across.low - left * along.low) / along.high;
    const double s = left * left;
    const double series =
        left * s * (-1.0 / 3 + s * (1.0 / 5 + s * (-1.0 / 7 + s * (1.0 / 9 - s / 11))));
    const Pair& whole = angles[static_cast<std::size_t>(nearest)];
    const Pair angle = sum(whole.high, left);
    return {angle.high, angle.low + (whole.low + rest + series)};
}

Pair difference(const Pair& a, const Pair& b) {
    const Pair high = sum(a.high, -b.high);
    return {high.high, high.low + (a.low - b.low)};
}

}  // namespace

}  // namespace asv::playground

extern "C" double atan2(double y, double x) {
    using namespace asv::playground;
    static const Pair half_turn = pair_of(4 * std::atan(1.0L)),
                      quarter_turn = pair_of(2 * std::atan(1.0L));
    const double across = std::fabs(y), along = std::fabs(x);
    const double least = std::fmin(across, along), most = std::fmax(across, along);
    // What is left is rare: zeros, infinities, numbers that are no numbers, products that
    // underflow.
    if (!(least > 0x1p-300 && most < 0x1p300 && least > most * 0x1p-30))
        return static_cast<double>(
            std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
    Pair angle = in_first_octant(most, least);
    if (across > along) angle = difference(quarter_turn, angle);
    if (x < 0) angle = difference(half_turn, angle);
    return std::copysign(angle.high + angle.low, y);
}
