#include "geometry/elementary/sine_cosine.hpp"

#include <cstddef>

namespace asv::elementary {

namespace {

// pi / 2 in three parts (Cody and Waite, 1980): the first two have so few digits that their product
// with a quarter count below 2^20 is exact.
constexpr double half_pi_1 = 0x1.921fb544p0;
constexpr double half_pi_2 = 0x1.0b4611a6p-34;
constexpr double half_pi_3 = 0x1.3198a2e037073p-69;
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
// Adding and subtracting 1.5 * 2^52 rounds to the nearest integer.
constexpr double round_to_integer = 0x1.8p52;

}  // namespace

// Written without branches, so that the compiler turns the loop into vector code; the clones give
// the same bits, since nothing is fused (-ffp-contract=off).
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
__attribute__((target_clones("default", "avx2", "avx512f")))
#endif
void sine_cosine(std::span<const double> angle, std::span<double> sine, std::span<double> cosine) {
    const double* in = angle.data();
    double* out_sine = sine.data();
    double* out_cosine = cosine.data();
    const std::size_t count = angle.size();
#if !defined(__clang__)
#pragma GCC ivdep
#endif
    for (std::size_t i = 0; i < count; ++i) {
        const double quarters = (in[i] * two_over_pi + round_to_integer) - round_to_integer;
        const double r =
            ((in[i] - quarters * half_pi_1) - quarters * half_pi_2) - quarters * half_pi_3;
        const double z = r * r;
        // Minimax polynomials on [-pi/4, pi/4] (the coefficients of Sun's fdlibm k_sin, k_cos).
        const double s = r + r * z *
                                 (-1.66666666666666324348e-01 +
                                  z * (8.33333333332248946124e-03 +
                                       z * (-1.98412698298579493134e-04 +
                                            z * (2.75573137070700676789e-06 +
                                                 z * (-2.50507602534068634195e-08 +
                                                      z * 1.58969099521155010221e-10)))));
        const double c =
            (1 - 0.5 * z) + z * z *
                                (4.16666666666666019037e-02 +
                                 z * (-1.38888888888741095749e-03 +
                                      z * (2.48015872894767294178e-05 +
                                           z * (-2.75573143513906633035e-07 +
                                                z * (2.08757232129817482790e-09 +
                                                     z * -1.13596475577881948265e-11)))));
        // The quarter q mod 4 as a number in {-2, -1, 0, 1, 2}.
        const double turns = (quarters * 0.25 + round_to_integer) - round_to_integer;
        const double q = quarters - 4 * turns;
        const bool odd = q == 1 || q == -1;
        const double sine_value = odd ? c : s;
        const double cosine_value = odd ? s : c;
        out_sine[i] = (q == 2 || q == -2 || q == -1) ? -sine_value : sine_value;
        out_cosine[i] = (q == 2 || q == -2 || q == 1) ? -cosine_value : cosine_value;
    }
}

}  // namespace asv::elementary
