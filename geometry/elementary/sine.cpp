#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/elementary/functions.hpp"
#include "geometry/elementary/pair.hpp"

namespace asv::elementary {

namespace {

/// Pieces of a full turn, and of a quarter.
constexpr std::int64_t pieces = 64, quarter = 16;
constexpr Pair piece{pi.high / (pieces / 2), pi.low / (pieces / 2)};
/// Beyond this angle, in radians, too few digits of pi are known here.
constexpr double greatest = 0x1p40;
/// The sine of what is less is the angle, but for a sixth of its cube.
constexpr double tiny = 0x1p-27;

/// The sine, or from the term 1 the cosine, of one piece by its series.
constexpr Pair series_of_piece(Pair term, int power) {
    const Pair square = product(piece, piece);
    Pair total = term;
    for (int i = 0; i < terms_of_series; ++i, power += 2) {
        const auto factor = static_cast<double>((power + 1) * (power + 2));
        term = quotient(product(-term, square), {factor, 0});
        total = sum(total, term);
    }
    return total;
}

/// The sines of all pieces, the first eighth of a turn by turning from piece to piece.
constexpr std::array<Pair, pieces> make_sines() {
    std::array<Pair, pieces> sines{};
    const Pair piece_sine = series_of_piece(piece, 1), piece_cosine = series_of_piece({1, 0}, 0);
    Pair sine{0, 0}, cosine{1, 0};
    for (std::size_t i = 0; i <= quarter / 2; ++i) {
        sines[i] = sine;
        sines[quarter - i] = cosine;
        const Pair turned = sum(product(sine, piece_cosine), product(cosine, piece_sine));
        cosine = sum(product(cosine, piece_cosine), -product(sine, piece_sine));
        sine = turned;
    }
    for (std::size_t i = 1; i <= quarter; ++i) sines[2 * quarter - i] = sines[i];
    for (std::size_t i = 0; i < 2 * quarter; ++i) sines[2 * quarter + i] = -sines[i];
    return sines;
}

constexpr std::array<Pair, pieces> sines = make_sines();

/// The sine of an angle that is turned by so many pieces: that of the nearest piece, and series for
/// what is left.
double turned_sine(double angle, std::int64_t turned) {
    if (!(std::fabs(angle) < greatest)) return std::numeric_limits<double>::quiet_NaN();
    const double nearest = nearest_integer(angle / piece.high);
    const Pair near = plus_product(angle, -nearest, piece.high);
    const Pair left = sum(near.high, near.low - nearest * piece.low);
    const auto at = [&](std::int64_t shift) {
        const std::int64_t index = (static_cast<std::int64_t>(nearest) + shift) & (pieces - 1);
        return sines[static_cast<std::size_t>(index)];
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

double sin(double angle) {
    return std::fabs(angle) < tiny ? angle : turned_sine(angle, 0);
}

double cos(double angle) {
    return turned_sine(angle, quarter);
}

}  // namespace asv::elementary
