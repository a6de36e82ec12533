#include "tests/kit/geometry/scalar_sin_cos.hpp"

#include <bit>
#include <cstdint>

#include "geometry/simd/sin_cos_constants.hpp"

namespace asv::test {

using namespace geometry::simd;

SinCos scalar_sin_cos(double angle) noexcept {
    const double shifted = angle * two_over_pi + shifter;
    const double turns = shifted - shifter;
    const double r = (angle - turns * half_pi_high) - turns * half_pi_low;
    const double z = r * r;
    double s = sine[5];
    for (int i = 4; i >= 0; --i) s = s * z + sine[i];
    s = r + r * (z * s);
    double c = cosine[6];
    for (int i = 5; i >= 0; --i) c = c * z + cosine[i];

    const auto quadrant = std::bit_cast<std::uint64_t>(shifted);
    const bool odd = (quadrant & 1) != 0;
    const bool sine_negative = (quadrant & 2) != 0;
    const bool cosine_negative = ((quadrant + 1) & 2) != 0;
    const double sin = odd ? c : s;
    const double cos = odd ? s : c;
    return {sine_negative ? -sin : sin, cosine_negative ? -cos : cos};
}

}  // namespace asv::test
