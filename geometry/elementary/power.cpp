#include <array>
#include <cmath>
#include <limits>

#include "geometry/elementary/functions.hpp"
#include "geometry/elementary/pair.hpp"

namespace asv::elementary {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double root_of_half = 0x1.6a09e667f3bcdp-1;

/// Logarithms of 1/64, 2/64, ... from about sqrt(1/2) to sqrt(2).
constexpr int parts = 64, first_part = 45, last_part = 91;

/// 2 atanh(1 / inverse), which is the logarithm of (inverse + 1) / (inverse - 1).
constexpr Pair log_of_step(double inverse) {
    const Pair square{inverse * inverse, 0};
    Pair power = quotient({2, 0}, {inverse, 0}), total = power;
    for (int i = 1; i < terms_of_series; ++i) {
        power = quotient(power, square);
        total = sum(total, quotient(power, {2.0 * i + 1, 0}));
    }
    return total;
}

/// From 1 up and down, each from the one before.
constexpr std::array<Pair, last_part + 1> make_logarithms() {
    std::array<Pair, last_part + 1> logarithms{};
    for (std::size_t i = parts + 1; i <= last_part; ++i)
        logarithms[i] = sum(logarithms[i - 1], log_of_step(2.0 * static_cast<double>(i) - 1));
    for (std::size_t i = parts - 1; i >= first_part; --i)
        logarithms[i] = sum(logarithms[i + 1], -log_of_step(2.0 * static_cast<double>(i) + 1));
    return logarithms;
}

constexpr std::array<Pair, last_part + 1> logarithms = make_logarithms();

/// Precondition: 0 < value < infinity.
Pair logarithm(double value) {
    int exponent;
    double mantissa = std::frexp(value, &exponent);
    if (mantissa < root_of_half) {
        mantissa *= 2;
        --exponent;
    }
    const double nearest = nearest_integer(parts * mantissa), part = nearest / parts;
    // log(mantissa / part) = 2 atanh(t) with t = (mantissa - part) / (mantissa + part).
    const Pair t = quotient({mantissa - part, 0}, sum(mantissa, part));
    const double z = t.high * t.high;
    const double series =
        2 * t.high * z * (1.0 / 3 + z * (1.0 / 5 + z * (1.0 / 7 + z * (1.0 / 9))));
    const Pair left = sum(2 * t.high, 2 * t.low + series);
    const Pair powers_of_two = product({static_cast<double>(exponent), 0}, log_2);
    return sum(sum(powers_of_two, logarithms[static_cast<std::size_t>(nearest)]), left);
}

/// Steps of the exponent to the base 2.
constexpr int steps = 32;
constexpr Pair step{log_2.high / steps, log_2.low / steps};
/// Beyond these, exp() is more or less than any number.
constexpr double greatest = 710, least = -746;
/// Exponents beyond this, where products overflow, make 0 or infinity of all bases but 1.
constexpr double large = 0x1p900;

/// 2^(0/32), 2^(1/32), ..., 2^(31/32).
constexpr std::array<Pair, steps> make_powers() {
    Pair term{1, 0}, factor{1, 0};
    for (int i = 1; i < terms_of_series; ++i) {
        term = quotient(product(term, step), {static_cast<double>(i), 0});
        factor = sum(factor, term);
    }
    std::array<Pair, steps> powers{};
    powers[0] = {1, 0};
    for (std::size_t i = 1; i < steps; ++i) powers[i] = product(powers[i - 1], factor);
    return powers;
}

constexpr std::array<Pair, steps> powers = make_powers();

double exponential(const Pair& exponent) {
    if (exponent.high > greatest) return infinity;
    if (exponent.high < least) return 0;
    const double nearest = nearest_integer(exponent.high / step.high);
    const Pair near = plus_product(exponent.high, -nearest, step.high);
    const Pair left = sum(near.high, near.low - nearest * step.low + exponent.low);
    const auto count = static_cast<int>(nearest);
    const int index = count & (steps - 1);
    const Pair& power = powers[static_cast<std::size_t>(index)];
    const double l = left.high;
    const double rest =
        left.low +
        l * l *
            (1.0 / 2 +
             l * (1.0 / 6 + l * (1.0 / 24 + l * (1.0 / 120 + l * (1.0 / 720 + l / 5040)))));
    const Pair across = product(power.high, l), total = sum(power.high, across.high);
    const double value =
        total.high + (total.low + across.low + power.low + power.low * l + power.high * rest);
    return std::ldexp(value, (count - index) / steps);
}

}  // namespace

double log(double value) {
    if (value == 0) return -infinity;
    if (!(value > 0)) return std::numeric_limits<double>::quiet_NaN();
    if (value == infinity) return infinity;
    return logarithm(value).high;
}

double exp(double exponent) {
    return std::isnan(exponent) ? exponent : exponential({exponent, 0});
}

double pow(double base, double exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (!(base > 0 && base < infinity && std::fabs(exponent) < large))
        return exp(exponent * log(base));
    return exponential(product({exponent, 0}, logarithm(base)));
}

}  // namespace asv::elementary
