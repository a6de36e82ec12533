#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/boxes/box_index.hpp"
#include "geometry/simd/pack.hpp"

/// What the chain kernels pass between their stages.

namespace asv::core::batch {

using geometry::Box;
using geometry::BoxIndex;
using geometry::Segment;
using geometry::simd::all_lanes;
using geometry::simd::LaneMask;
using geometry::simd::lanes;
using geometry::simd::Pack;

}  // namespace asv::core::batch

namespace asv::core::batch::detail {

/// One link of eight chains in single precision, ready for comparison with boxes: the region that
/// it sweeps and, on the axis along its normal, its shadow offset +- half_width.
struct alignas(64) SweptLink {
    using Row = std::array<float, lanes>;
    Row low_x, low_y, high_x, high_y, normal_x, normal_y, offset, half_width;
};

/// A box grown by the slack of comparing links with boxes, in single precision.
struct GrownBox {
    float low_x, low_y, high_x, high_y, centre_x, centre_y, half_x, half_y;
};

inline GrownBox grown(const Box& box, float margin) {
    const float low_x = static_cast<float>(box.low.x) - margin;
    const float low_y = static_cast<float>(box.low.y) - margin;
    const float high_x = static_cast<float>(box.high.x) + margin;
    const float high_y = static_cast<float>(box.high.y) + margin;
    return {low_x,
            low_y,
            high_x,
            high_y,
            0.5F * (low_x + high_x),
            0.5F * (low_y + high_y),
            0.5F * (high_x - low_x),
            0.5F * (high_y - low_y)};
}

/// Up to here every box that comes near one of eight chains is compared with all their links.
inline constexpr std::size_t few_boxes = 256;

/// Working memory of one ChainBatch.
struct ChainScratch {
    std::vector<Pack> x, y;                      ///< points
    std::vector<Pack> direction_x, direction_y;  ///< of the links
    std::vector<SweptLink> links;
    SweptLink whole;            ///< regions that hold the whole chains; nothing else of it is used
    double rounding = 0;        ///< more than any room of a stretch may be off by
    float slack = 0;            ///< more than the comparison of a link with a box may be off by
    std::vector<GrownBox> few;  ///< the boxes of the tree in its order, if they are few
};

/// Bits of LaneMask; certified without a motion means valid.
struct LaneVerdict {
    std::uint32_t certified = 0;
    std::uint32_t valid = 0;
};

}  // namespace asv::core::batch::detail
