#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Structure-of-arrays values for the SIMD kernels.

namespace asv::geometry::simd {

inline constexpr std::size_t lanes = 8;

/// The same quantity of eight chains side by side, one chain to a lane on every processor.
struct alignas(64) Pack {
    std::array<double, lanes> lane{};

    double& operator[](std::size_t i) { return lane[i]; }
    double operator[](std::size_t i) const { return lane[i]; }
};

/// Bit l speaks for lane l.
using LaneMask = std::uint32_t;
inline constexpr LaneMask all_lanes = (1U << lanes) - 1;

}  // namespace asv::geometry::simd
