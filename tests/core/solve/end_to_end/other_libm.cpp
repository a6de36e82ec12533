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
#define ASV_OTHER_OF_ONE(name)              \
    double name(double x) noexcept {        \
        return rounded(std::name(wide(x))); \
    }
#define ASV_OTHER_OF_TWO(name)                       \
    double name(double x, double y) noexcept {       \
        return rounded(std::name(wide(x), wide(y))); \
    }
ASV_OTHER_OF_ONE(acos)
ASV_OTHER_OF_ONE(asin)
ASV_OTHER_OF_ONE(atan)
ASV_OTHER_OF_ONE(cbrt)
ASV_OTHER_OF_ONE(cos)
ASV_OTHER_OF_ONE(exp)
ASV_OTHER_OF_ONE(exp2)
ASV_OTHER_OF_ONE(expm1)
ASV_OTHER_OF_ONE(log)
ASV_OTHER_OF_ONE(log10)
ASV_OTHER_OF_ONE(log1p)
ASV_OTHER_OF_ONE(log2)
ASV_OTHER_OF_ONE(sin)
ASV_OTHER_OF_ONE(tan)
ASV_OTHER_OF_TWO(atan2)
ASV_OTHER_OF_TWO(hypot)
ASV_OTHER_OF_TWO(pow)
void sincos(double x, double* sine, double* cosine) noexcept {
    *sine = sin(x);
    *cosine = cos(x);
}
}
