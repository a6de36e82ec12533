#pragma once

#include <cstddef>
#include <span>

namespace asv::geometry::simd {

/// Configurations of a block.
inline constexpr std::size_t block_rows = 16;

/// A row to measure from, in single precision. A coordinate whose period is not 0 wraps: values
/// that differ by a multiple of the period are the same, and inverse_period is 1 / period. Else
/// both are 0.
struct WrappingRow {
    std::span<const float> value, period, inverse_period;
};

/// Squared Euclidean distances from a row to blocks of 16 rows, and the least one of each block.
/// The same bits on every processor. blocks: block after block, in a block coordinate after
/// coordinate, 16 values each. squared: 16 for each block. Precondition: blocks.size() == 16 *
/// dimension * least.size(), squared.size() == 16 * least.size(); differences are below 2^22
/// periods.
void squared_distances(std::span<const float> blocks, const WrappingRow& from,
                       std::span<float> squared, std::span<float> least) noexcept;

}  // namespace asv::geometry::simd
