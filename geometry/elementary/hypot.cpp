#include <cmath>
#include <limits>

#include "geometry/elementary/functions.hpp"

namespace asv::elementary {

namespace {

/// Above and below these, squares overflow or lose digits, and both sides are scaled before.
constexpr double large = 0x1p+511, small = 0x1p-459, scale = 0x1p-600;
/// A side that is shorter by so much does not change the other one's last digit.
constexpr double negligible = 0x1p-54;

/// The root of the squares' sum, with a correction of the first order (C. F. Borges, "An improved
/// algorithm for hypot(a, b)", 2019, without fused operations). Precondition: a >= b >= 0.
double corrected(double a, double b) {
    const double root = std::sqrt(a * a + b * b);
    double excess;  // of the root's square
    if (root <= 2 * b) {
        const double delta = root - b;
        excess = a * (2 * delta - a) + (delta - 2 * (a - b)) * delta;
    } else {
        const double delta = root - a;
        excess = 2 * delta * (a - 2 * b) + ((4 * delta - b) * b + delta * delta);
    }
    return root - excess / (2 * root);
}

}  // namespace

double hypot(double x, double y) {
    x = std::fabs(x);
    y = std::fabs(y);
    const double a = x < y ? y : x, b = x < y ? x : y;
    if (a <= large && b >= small && b > a * negligible) return corrected(a, b);
    if (std::isinf(x) || std::isinf(y)) return std::numeric_limits<double>::infinity();
    if (!(b > a * negligible)) return a + b;
    if (a > large) return corrected(a * scale, b * scale) / scale;
    return corrected(a / scale, b / scale) * scale;
}

}  // namespace asv::elementary
