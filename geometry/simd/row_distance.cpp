#include "geometry/simd/row_distance.hpp"

#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/simd/row_distance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geometry/simd/dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::simd::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, block_rows>;
using V = hn::Vec<D>;

/// From the row to those of a block that are in the lanes from its begin on. Nothing is fused.
HWY_INLINE V squared_distance(const float* begin, const WrappingRow& from) {
    const D d;
    const auto round_to_integer = hn::Set(d, 12582912.F);  // 1.5 * 2^23
    auto sum = hn::Zero(d);
    for (std::size_t i = 0; i < from.value.size(); ++i, begin += block_rows) {
        auto difference = hn::Sub(hn::LoadU(d, begin), hn::Set(d, from.value[i]));
        if (from.period[i] != 0) {
            const auto periods = hn::Mul(difference, hn::Set(d, from.inverse_period[i]));
            const auto whole = hn::Sub(hn::Add(periods, round_to_integer), round_to_integer);
            difference = hn::Sub(difference, hn::Mul(hn::Set(d, from.period[i]), whole));
        }
        sum = hn::Add(sum, hn::Mul(difference, difference));
    }
    return sum;
}

void SquaredDistances(std::span<const float> blocks, const WrappingRow& from,
                      std::span<float> squared, std::span<float> least) {
    const D d;
    const float* block = blocks.data();
    float* out = squared.data();
    for (std::size_t b = 0; b < least.size(); ++b) {
        auto block_least = squared_distance(block, from);
        hn::StoreU(block_least, d, out);
        for (std::size_t lane = hn::Lanes(d); lane < block_rows; lane += hn::Lanes(d)) {
            const auto distances = squared_distance(block + lane, from);
            hn::StoreU(distances, d, out + lane);
            block_least = hn::Min(block_least, distances);
        }
        least[b] = hn::GetLane(hn::MinOfLanes(d, block_least));
        block += block_rows * from.value.size();
        out += block_rows;
    }
}

}  // namespace
}  // namespace asv::geometry::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asv::geometry::simd {

namespace {
ASV_SIMD_EXPORT(SquaredDistances);
}

void squared_distances(std::span<const float> blocks, const WrappingRow& from,
                       std::span<float> squared, std::span<float> least) noexcept {
    assert(blocks.size() == block_rows * from.value.size() * least.size());
    assert(squared.size() == block_rows * least.size());
    ASV_SIMD_DISPATCH(SquaredDistances)(blocks, from, squared, least);
}

}  // namespace asv::geometry::simd
#endif  // HWY_ONCE
