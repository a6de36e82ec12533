#pragma once

/// Shared by the scalar and the SIMD sine and cosine, which round alike operation by operation (no
/// fused multiply-add).
///
/// The angle becomes r + k pi/2 with |r| <= pi/4 (1 + 2^-20). k = round(angle * 2/pi) is found by
/// adding 1.5 * 2^52, which leaves k in the lowest bits of the sum. k * half_pi_high is exact for
/// |k| < 2^20 as half_pi_high has 33 bits, and so is its difference from the angle (Sterbenz); what
/// is left costs r an error of 2^-54 + 2^-60 (Cody and Waite, 1980).
///
/// The polynomials are minimax on that interval, found by Remez exchange in 200-bit arithmetic:
///     sin r = r + r z (sine[0] + ... + sine[5] z^5)    with error 2^-56,  z = r^2,
///     cos r = 1 - z/2 + z^2 (cosine[2] + ... )         with error 2^-53.5.
/// The last three roundings add 2^-54 + 2^-55 + 2^-54.7, which makes 2.4e-16 in all.

namespace asv::geometry::simd {

inline constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
inline constexpr double shifter = 0x1.8p52;
inline constexpr double half_pi_high = 0x1.921fb544p0;
inline constexpr double half_pi_low = 0x1.0b4611a626331p-34;
inline constexpr double sine[] = {-0x1.555555555553dp-3,  0x1.111111110eb1fp-7,
                                  -0x1.a01a019ab4ad8p-13, 0x1.71de3475641b4p-19,
                                  -0x1.ae5db47815a40p-26, 0x1.5d64c913fd42bp-33};
inline constexpr double cosine[] = {1.0,
                                    -0.5,
                                    0x1.5555555553113p-5,
                                    -0x1.6c16c1676ba87p-10,
                                    0x1.a019faaa6200fp-16,
                                    -0x1.27e02a89c9f9ap-22,
                                    0x1.1bc7c4aa55639p-29};

}  // namespace asv::geometry::simd
