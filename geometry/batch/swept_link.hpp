#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asv/geometry/batch/pack.hpp"

/// What the chain kernels pass between their stages.

namespace asv::geometry::batch::detail {

/// One link of eight chains in single precision, ready for comparison with boxes: the region that
/// it sweeps and, on the axis along its normal, its shadow offset +- reach.
struct alignas(64) SweptLink {
    using Row = std::array<float, lanes>;
    Row low_x, low_y, high_x, high_y, normal_x, normal_y, offset, reach;
};

/// Working memory of one ChainBatch.
struct ChainScratch {
    std::vector<Pack> x, y;                      ///< points
    std::vector<Pack> direction_x, direction_y;  ///< of the links
    std::vector<SweptLink> links;
    SweptLink whole;      ///< regions that hold the whole chains; nothing else of it is used
    double rounding = 0;  ///< more than any room of a stretch may be off by
    float slack = 0;      ///< more than the comparison of a link with a box may be off by
};

/// Bits of LaneMask; certified without a motion means valid.
struct LaneVerdict {
    std::uint32_t certified = 0;
    std::uint32_t valid = 0;
};

}  // namespace asv::geometry::batch::detail
