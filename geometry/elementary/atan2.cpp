#include <array>
#include <cmath>

#include "geometry/elementary/functions.hpp"
#include "geometry/elementary/pair.hpp"

namespace asv::elementary {

namespace {

constexpr Pair half_turn = pi, quarter_turn{pi.high / 2, pi.low / 2};

/// Between tangents of the table.
constexpr int pieces = 32;
/// An angle whose tangent is less is that tangent, but for a third of its cube.
constexpr double tiny = 0x1p-30;
/// Beyond these, products with coordinates over- or underflow.
constexpr double large = 0x1p900, small = 0x1p-900, scale = 0x1p600;

/// By its series, for 0 <= tangent <= 1/32.
constexpr Pair small_angle(const Pair& tangent) {
    const Pair square = product(tangent, tangent);
    Pair power = tangent, total = tangent;
    for (int i = 1; i < terms_of_series; ++i) {
        power = product(-power, square);
        total = sum(total, quotient(power, {2.0 * i + 1, 0}));
    }
    return total;
}

/// The angles whose tangents are 0, 1/32, ..., 1, each from the one before: the tangent of the
/// difference between tangents a and b is (a - b) / (1 + a b).
constexpr std::array<Pair, pieces + 1> make_angles() {
    std::array<Pair, pieces + 1> angles{};
    for (std::size_t i = 1; i <= pieces; ++i) {
        const auto along = static_cast<double>(pieces * pieces + i * (i - 1));
        angles[i] = sum(angles[i - 1], small_angle(quotient({pieces, 0}, {along, 0})));
    }
    return angles;
}

constexpr std::array<Pair, pieces + 1> angles = make_angles();

/// a + factor * b. Precondition: factor has at most 26 digits, so that its products with halves are
/// exact.
Pair plus_short_product(double a, double factor, double b) {
    const Pair parts = halves(b), total = sum(a, factor * parts.high);
    return sum(total.high, total.low + factor * parts.low);
}

/// Of a point in the first octant: the nearest of the angles above, and a series for what is left.
Pair in_first_octant(double x, double y) {
    if (y < x * tiny) return {y / x, 0};
    const double nearest = nearest_integer(pieces * (y / x));
    const double tangent = nearest / pieces;
    // The tangent of what is left is (y - tangent x) / (x + tangent y).
    const Pair across = plus_short_product(y, -tangent, x),
               along = plus_short_product(x, tangent, y);
    const double inverse = 1 / along.high;
    const double left = (across.high + across.low) * inverse;
    const Pair back = product(left, along.high);
    const double rest =
        (((across.high - back.high) - back.low) + across.low - left * along.low) * inverse;
    const double s = left * left;
    const double series =
        left * s * (-1.0 / 3 + s * (1.0 / 5 + s * (-1.0 / 7 + s * (1.0 / 9 - s / 11))));
    const Pair& whole = angles[static_cast<std::size_t>(nearest)];
    const Pair angle = sum(whole.high, left);
    return {angle.high, angle.low + (whole.low + rest + series)};
}

/// The same for what has no size, or one at the ends of what numbers can be.
Pair of_rare_size(double x, double y) {
    if (x == 0) return {0, 0};
    if (std::isinf(x)) return in_first_octant(1, std::isinf(y) ? 1 : 0);
    if (x >= large) return in_first_octant(x / scale, y / scale);
    return in_first_octant(x * scale, y * scale);
}

}  // namespace

double atan2(double y, double x) {
    if (std::isunordered(x, y)) return x + y;
    const double across = std::fabs(y), along = std::fabs(x);
    const double least = across < along ? across : along, most = across < along ? along : across;
    Pair angle =
        most > small && most < large ? in_first_octant(most, least) : of_rare_size(most, least);
    if (across > along) angle = sum(quarter_turn, -angle);
    if (std::signbit(x)) angle = sum(half_turn, -angle);
    return std::copysign(angle.high + angle.low, y);
}

}  // namespace asv::elementary
