#pragma once

/// Arithmetic with twice the digits of double, for functions of the C library that are rounded
/// correctly in nearly every case. The GNU C library, which the programs are built with, rounds
/// them correctly but for one in a thousand; that of Emscripten is off by a last bit much more
/// often, and one bit gives a chain another path.

namespace asv::playground {

/// high + low, where low is at most half a unit in the last place of high.
struct Pair {
    double high, low;
};

inline Pair pair_of(long double value) {
    const auto high = static_cast<double>(value);
    return {high, static_cast<double>(value - high)};
}

/// Exact (Knuth).
inline Pair sum(double a, double b) {
    const double rounded = a + b, part = rounded - a;
    return {rounded, (a - (rounded - part)) + (b - part)};
}

/// Exact where nothing over- or underflows (Dekker, 1971).
inline Pair product(double a, double b) {
    constexpr double splitter = 0x1p27 + 1;
    const auto halves = [](double value) {
        const double scaled = splitter * value, high = scaled - (scaled - value);
        return Pair{high, value - high};
    };
    const Pair x = halves(a), y = halves(b);
    const double rounded = a * b;
    const double rest =
        ((x.high * y.high - rounded) + x.high * y.low + x.low * y.high) + x.low * y.low;
    return {rounded, rest};
}

/// a + factor * b.
inline Pair plus_product(double a, double factor, double b) {
    const Pair added = product(factor, b), total = sum(a, added.high);
    return {total.high, total.low + added.low};
}

}  // namespace asv::playground
