#include "tests/core/solve/end_to_end/other_libm.hpp"

#include <atomic>
#include <cmath>

namespace {

std::atomic<bool> off_by_one_bit = false;

double rounded(long double value) {
    const auto nearest = static_cast<double>(value);
    return off_by_one_bit ? std::nextafter(nearest, HUGE_VAL) : nearest;
}

long double wide(double value) {
    return value;
}

}  // namespace

namespace asv::test {

OtherLibm::OtherLibm() {
    off_by_one_bit = true;
}

OtherLibm::~OtherLibm() {
    off_by_one_bit = false;
}

}  // namespace asv::test

// A program's own functions go before those of the C library.
extern "C" {
double acos(double x) noexcept {
    return rounded(std::acos(wide(x)));
}
double asin(double x) noexcept {
    return rounded(std::asin(wide(x)));
}
double atan(double x) noexcept {
    return rounded(std::atan(wide(x)));
}
double atan2(double y, double x) noexcept {
    return rounded(std::atan2(wide(y), wide(x)));
}
double cbrt(double x) noexcept {
    return rounded(std::cbrt(wide(x)));
}
double cos(double x) noexcept {
    return rounded(std::cos(wide(x)));
}
double exp(double x) noexcept {
    return rounded(std::exp(wide(x)));
}
double exp2(double x) noexcept {
    return rounded(std::exp2(wide(x)));
}
double expm1(double x) noexcept {
    return rounded(std::expm1(wide(x)));
}
double hypot(double x, double y) noexcept {
    return rounded(std::hypot(wide(x), wide(y)));
}
double log(double x) noexcept {
    return rounded(std::log(wide(x)));
}
double log10(double x) noexcept {
    return rounded(std::log10(wide(x)));
}
double log1p(double x) noexcept {
    return rounded(std::log1p(wide(x)));
}
double log2(double x) noexcept {
    return rounded(std::log2(wide(x)));
}
double pow(double x, double y) noexcept {
    return rounded(std::pow(wide(x), wide(y)));
}
double sin(double x) noexcept {
    return rounded(std::sin(wide(x)));
}
double tan(double x) noexcept {
    return rounded(std::tan(wide(x)));
}
void sincos(double x, double* sine, double* cosine) noexcept {
    *sine = sin(x);
    *cosine = cos(x);
}
}
