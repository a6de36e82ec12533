#pragma once

#include <cmath>

/// The mathematical functions whose last digits differ from one C library and processor to the
/// next, here by operations that IEEE 754 rounds everywhere alike: + - * / and square roots. So
/// they give the same bits on every machine; what planners and the validator compute, they compute
/// with these. (std::sqrt, floor, round, fabs, remainder, frexp and ldexp are exact in every
/// library.)
///
/// Errors are in ulp, units in the last place of the result: 0.5 ulp is the nearest number. Zeros,
/// infinities and numbers that are none are taken as by the C library, if not told
/// otherwise.

namespace asv::elementary {

/// Sine and cosine of an angle in radians: within 0.51 ulp for |angle| <= 8, within 0.51 ulp of 1
/// for |angle| < 2^40; beyond that not a number.
double sin(double angle);
double cos(double angle);

/// sin(angle) / cos(angle), within 2 ulp for |angle| <= 8.
inline double tan(double angle) {
    return sin(angle) / cos(angle);
}

/// The heading of (x, y), from -pi to pi: within 0.51 ulp, where it is not subnormal.
double atan2(double y, double x);

/// Within 3 ulp.
inline double asin(double sine) {
    return atan2(sine, std::sqrt((1 - sine) * (1 + sine)));
}

/// The length of (x, y), within 1 ulp. It rounds as the GNU C library does since its version 2.35.
double hypot(double x, double y);

/// Natural logarithm, within 0.51 ulp; -infinity of 0, not a number of what is negative.
double log(double value);

/// Within 0.52 ulp; where the result is subnormal, 1 ulp.
double exp(double exponent);

/// Within 0.52 ulp; where the result is subnormal, 1 ulp. Precondition: base >= 0.
double pow(double base, double exponent);

}  // namespace asv::elementary
