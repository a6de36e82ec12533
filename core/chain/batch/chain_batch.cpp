#include "core/chain/batch/chain_batch.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/chain/batch/chain_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/chain/batch/chain_shape-inl.hpp"
#include "core/chain/batch/link_search-inl.hpp"
#include "geometry/predicates/segment_box.hpp"
#include "geometry/simd/dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::core::batch::HWY_NAMESPACE {
namespace {

/// Exact: the lanes in which one of the links meets the box.
LaneMask meeting(const detail::ChainScratch& scratch, const Box& box, LaneMask of,
                 std::size_t first, std::size_t count) {
    LaneMask found = 0;
    for (; of != 0; of &= of - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctz(of));
        for (std::size_t k = first; k < first + count; ++k) {
            const Segment link{{scratch.x[k][i], scratch.y[k][i]},
                               {scratch.x[k + 1][i], scratch.y[k + 1][i]}};
            if (!meets(link, box)) continue;
            found |= 1U << i;
            break;
        }
    }
    return found;
}

template <class Source>
HWY_INLINE detail::LaneVerdict judge(const ChainLimits& limits, const BoxIndex& boxes,
                                     const Source& source, detail::ChainScratch& scratch) {
    detail::LaneVerdict verdict;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(Double8())) {
        const auto [certified, valid] = ChainWalk<Source>(limits, source, scratch, i).walk();
        verdict.certified |= certified << i;
        verdict.valid |= valid << i;
    }
    LaneMask alive = verdict.valid;
    auto on_hit = [&](const Box& box, LaneMask hit, std::size_t first, std::size_t count) {
        verdict.certified &= ~hit;
        alive &= ~meeting(scratch, box, hit, first, count);
    };
    LinkSearch<Source::moving, decltype(on_hit)>(scratch, boxes, alive, on_hit).search();
    verdict.valid = alive;
    return verdict;
}

LaneMask Valid(const ChainLimits& limits, const BoxIndex& boxes, std::span<const Pack> rows,
               detail::ChainScratch& scratch) {
    return judge(limits, boxes, Resting{rows}, scratch).valid;
}

detail::LaneVerdict Certify(const ChainLimits& limits, const BoxIndex& boxes,
                            const Stretches& stretches, detail::ChainScratch& scratch) {
    return judge(limits, boxes, Moving{stretches}, scratch);
}

}  // namespace
}  // namespace asv::core::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asv::core::batch {

namespace {

ASV_SIMD_EXPORT(Valid);
ASV_SIMD_EXPORT(Certify);

}  // namespace

// The slack of comparing a link with a box in single precision, where every coordinate is at most M
// in magnitude, normals have length 1 and e = 2^-24. A shadow on the normal takes |x| + |y| <=
// sqrt(2) of an error that both coordinates have. Such errors are e M each, of: the offset, the
// normal, the sides of the box, these grown by the slack, its centre, its extent, and the products
// with either: 8 sqrt(2) e M. The sums have at most 2.5 e M, 2.9 e M and 2.5 e M. That is less than
// 20 e M; 2^-19 M is 32 e M. Where regions are compared, 3 e M would do. The sums of the stretches
// in double precision are off by less than 2^-50 (1 + M + total length)^2 for up to a thousand
// links; 2^-44 also leaves room to positions that are computed in another order.
ChainBatch::ChainBatch(std::size_t links, const ChainLimits& limits, const BoxIndex& boxes)
    : limits_(limits), boxes_(boxes) {
    assert(links >= 1);
    assert(limits.min_turn.size() + 1 == links);
    assert(limits.anchor_lever.empty() || limits.anchor_lever.size() == links);
    for (auto* points : {&scratch_.x, &scratch_.y}) points->resize(links + 1);
    for (auto* directions : {&scratch_.direction_x, &scratch_.direction_y})
        directions->resize(links);
    scratch_.links.resize(links);
    const auto& [low, high] = limits.bounds;
    const double largest = std::max({std::fabs(low.x), std::fabs(low.y), std::fabs(high.x),
                                     std::fabs(high.y), boxes.tree().largest_coordinate});
    const double size = 1 + largest + static_cast<double>(links) * limits.link;
    scratch_.slack = static_cast<float>(0x1p-19 * largest);
    scratch_.rounding = 0x1p-44 * size * size;
    const auto& tree = boxes.beside_dust();
    if (tree.order.size() > detail::few_boxes) return;
    for (std::size_t i = 0; i < tree.order.size(); ++i) {
        scratch_.few.push_back(detail::grown(tree.boxes[i], scratch_.slack));
    }
}

LaneMask ChainBatch::valid(std::span<const Pack> rows) {
    assert(rows.size() == links() + 2);
    return ASV_SIMD_DISPATCH(Valid)(limits_, boxes_, rows, scratch_);
}

StretchVerdict ChainBatch::certify(const Stretches& stretches) {
    assert(stretches.from.size() == links() + 2 && stretches.step.size() == links() + 2);
    const auto [certified, valid] =
        ASV_SIMD_DISPATCH(Certify)(limits_, boxes_, stretches, scratch_);
    return {certified & valid, valid};
}

}  // namespace asv::core::batch
#endif  // HWY_ONCE
