#pragma once

namespace asv::test {

struct SinCos {
    double sin;
    double cos;
};

/// Sine and cosine of an angle in radians, with an absolute error below 3e-16, for |angle| < 2^20;
/// the same bits as the SIMD kernels compute, on every processor. Without a branch or a table.
SinCos scalar_sin_cos(double angle) noexcept;

}  // namespace asv::test
