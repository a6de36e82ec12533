// Compiled once for every instruction set; include only between HWY_BEFORE_NAMESPACE and its end.
#if defined(ASV_GEOMETRY_SIMD_SIN_COS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_GEOMETRY_SIMD_SIN_COS_INL_HPP
#undef ASV_GEOMETRY_SIMD_SIN_COS_INL_HPP
#else
#define ASV_GEOMETRY_SIMD_SIN_COS_INL_HPP
#endif

#include <hwy/highway.h>

#include "geometry/simd/sin_cos_constants.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::simd::HWY_NAMESPACE {

/// As batch::sin_cos, for every lane and with the same bits.
template <class D, class V = hwy::HWY_NAMESPACE::Vec<D>>
HWY_INLINE void sin_cos(D d, V angle, V& sin, V& cos) {
    namespace hn = hwy::HWY_NAMESPACE;
    const auto set = [d](double value) HWY_ATTR { return hn::Set(d, value); };
    const auto horner = [](V sum, V z, V next) HWY_ATTR { return hn::Add(hn::Mul(sum, z), next); };

    const V shifted = hn::Add(hn::Mul(angle, set(two_over_pi)), set(shifter));
    const V turns = hn::Sub(shifted, set(shifter));
    const V r = hn::Sub(hn::Sub(angle, hn::Mul(turns, set(half_pi_high))),
                        hn::Mul(turns, set(half_pi_low)));
    const V z = hn::Mul(r, r);
    V s = set(sine[5]);
    for (int i = 4; i >= 0; --i) s = horner(s, z, set(sine[i]));
    s = hn::Add(r, hn::Mul(r, hn::Mul(z, s)));
    V c = set(cosine[6]);
    for (int i = 5; i >= 0; --i) c = horner(c, z, set(cosine[i]));

    // Bit 0 of k swaps the two, bit 1 of k turns the sine's sign and bit 1 of k + 1 the cosine's.
    const hn::RebindToUnsigned<D> du;
    const auto k = hn::BitCast(du, shifted);
    // (Not IfNegativeThenElse, which in Highway 1.0.3 looks at more than the sign on SSSE3.)
    const auto odd = hn::RebindMask(d, hn::TestBit(k, hn::Set(du, 1)));
    const auto sign = [d](auto bits) HWY_ATTR {
        return hn::And(hn::BitCast(d, hn::ShiftLeft<62>(bits)), hn::SignBit(d));
    };
    sin = hn::Xor(hn::IfThenElse(odd, c, s), sign(k));
    cos = hn::Xor(hn::IfThenElse(odd, s, c), sign(hn::Add(k, hn::Set(du, 1))));
}

}  // namespace asv::geometry::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
