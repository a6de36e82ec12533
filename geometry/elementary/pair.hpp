#pragma once

/// Arithmetic with twice the digits of double, by + - * / alone. Each result is within some
/// 2^-104 of its size, as long as nothing overflows, no product is below 2^-960 and no sum is much
/// less than its summands.

namespace asv::elementary {

/// high + low, where low is at most half a unit in the last place of high.
struct Pair {
    double high, low;
};

inline constexpr Pair pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr Pair log_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/// Exact (Knuth).
constexpr Pair sum(double a, double b) {
    const double rounded = a + b, part = rounded - a;
    return {rounded, (a - (rounded - part)) + (b - part)};
}

constexpr Pair sum(const Pair& a, const Pair& b) {
    const Pair high = sum(a.high, b.high);
    return sum(high.high, high.low + (a.low + b.low));
}

constexpr Pair operator-(const Pair& a) {
    return {-a.high, -a.low};
}

/// The upper half of the digits, and the lower one (Veltkamp).
constexpr Pair halves(double value) {
    constexpr double splitter = 0x1p27 + 1;
    const double scaled = splitter * value, high = scaled - (scaled - value);
    return {high, value - high};
}

/// Exact where nothing over- or underflows (Dekker, 1971).
constexpr Pair product(double a, double b) {
    const Pair x = halves(a), y = halves(b);
    const double rounded = a * b;
    const double rest =
        ((x.high * y.high - rounded) + x.high * y.low + x.low * y.high) + x.low * y.low;
    return {rounded, rest};
}

constexpr Pair product(const Pair& a, const Pair& b) {
    const Pair high = product(a.high, b.high);
    return sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

/// a + factor * b.
constexpr Pair plus_product(double a, double factor, double b) {
    const Pair added = product(factor, b), total = sum(a, added.high);
    return {total.high, total.low + added.low};
}

constexpr Pair quotient(const Pair& a, const Pair& b) {
    const double rounded = a.high / b.high;
    const Pair back = product(rounded, b.high);
    const double rest = (((a.high - back.high) - back.low) + (a.low - rounded * b.low)) / b.high;
    return sum(rounded, rest);
}

/// The nearest integer, of two the even one. Precondition: |value| < 2^51.
constexpr double nearest_integer(double value) {
    constexpr double no_digits_left = 0x1.8p52;  // for fractions
    return (value + no_digits_left) - no_digits_left;
}

/// As many terms of a series as change a Pair, where each is at most 1/32 of the one before.
inline constexpr int terms_of_series = 22;

}  // namespace asv::elementary
