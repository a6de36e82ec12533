// Links of eight chains against many boxes; compiled once for every instruction set.
#if defined(ASV_GEOMETRY_BATCH_LINK_SEARCH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_GEOMETRY_BATCH_LINK_SEARCH_INL_HPP
#undef ASV_GEOMETRY_BATCH_LINK_SEARCH_INL_HPP
#else
#define ASV_GEOMETRY_BATCH_LINK_SEARCH_INL_HPP
#endif

#include <algorithm>
#include <span>

#include <hwy/highway.h>

#include "asv/geometry/batch/pack.hpp"
#include "asv/geometry/batch/swept_link.hpp"
#include "asv/geometry/box_query-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace query = geometry::detail::HWY_NAMESPACE;
using detail::SweptLink;
using geometry::detail::BoxQuery;
using geometry::detail::BoxTree;
using geometry::detail::WideNode;
using query::Float8;
using query::Floats;

/// One box of a node, grown by the slack of the comparison.
struct Target {
    float low_x, low_y, high_x, high_y, slack;

    HWY_INLINE Target(const WideNode& node, std::size_t lane, float margin)
        : low_x(node.low_x[lane] - margin),
          low_y(node.low_y[lane] - margin),
          high_x(node.high_x[lane] + margin),
          high_y(node.high_y[lane] + margin),
          slack(margin) {}
};

HWY_INLINE hn::Mask<Float8> regions_apart(const SweptLink& link, const Target& box, std::size_t i) {
    const Float8 d;
    return hn::Or(hn::Or(hn::Gt(hn::Load(d, link.low_x.data() + i), hn::Set(d, box.high_x)),
                         hn::Lt(hn::Load(d, link.high_x.data() + i), hn::Set(d, box.low_x))),
                  hn::Or(hn::Gt(hn::Load(d, link.low_y.data() + i), hn::Set(d, box.high_y)),
                         hn::Lt(hn::Load(d, link.high_y.data() + i), hn::Set(d, box.low_y))));
}

/// Bit l: some of the links may meet the box in lane l.
template <bool moving>
HWY_INLINE LaneMask hits(std::span<const SweptLink> links, const Target& box) {
    const Float8 d;
    const auto center_x = hn::Set(d, 0.5F * (box.low_x + box.high_x));
    const auto center_y = hn::Set(d, 0.5F * (box.low_y + box.high_y));
    const auto half_x = hn::Set(d, 0.5F * (box.high_x - box.low_x));
    const auto half_y = hn::Set(d, 0.5F * (box.high_y - box.low_y));
    LaneMask bits = 0;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
        auto all_apart = hn::FirstN(d, lanes);
        for (const SweptLink& link : links) {
            const auto x = hn::Load(d, link.normal_x.data() + i);
            const auto y = hn::Load(d, link.normal_y.data() + i);
            const auto offset = hn::Load(d, link.offset.data() + i);
            const auto between = hn::MulAdd(y, center_y, hn::MulSub(x, center_x, offset));
            auto most = hn::Set(d, box.slack);
            if (moving) most = hn::Add(most, hn::Load(d, link.reach.data() + i));
            most = hn::MulAdd(hn::Abs(y), half_y, hn::MulAdd(hn::Abs(x), half_x, most));
            const auto apart = hn::Or(regions_apart(link, box, i), hn::Gt(hn::Abs(between), most));
            all_apart = hn::And(all_apart, apart);
        }
        bits |= query::to_bits(d, hn::Not(all_apart)) << i;
    }
    return bits;
}

/// Bit l: the region in lane l may meet the box.
HWY_INLINE LaneMask region_hits(const SweptLink& region, const Target& box) {
    const Float8 d;
    LaneMask bits = 0;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
        bits |= query::to_bits(d, hn::Not(regions_apart(region, box, i))) << i;
    }
    return bits;
}

/// The smallest region that holds those of the lanes that are asked for.
inline BoxQuery joint_query(const SweptLink& link, LaneMask of, float slack) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    BoxQuery joint{infinity, infinity, -infinity, -infinity, 0, 0, -infinity, infinity};
    for (std::size_t i = 0; i < lanes; ++i) {
        if ((of >> i & 1) == 0) continue;
        joint.low_x = std::min(joint.low_x, link.low_x[i] - slack);
        joint.low_y = std::min(joint.low_y, link.low_y[i] - slack);
        joint.high_x = std::max(joint.high_x, link.high_x[i] + slack);
        joint.high_y = std::max(joint.high_y, link.high_y[i] + slack);
    }
    return joint;
}

inline BoxQuery lane_query(const SweptLink& link, std::size_t i, bool moving, float slack) {
    const float reach = slack + (moving ? link.reach[i] : 0);
    return {link.low_x[i] - slack,  link.low_y[i] - slack, link.high_x[i] + slack,
            link.high_y[i] + slack, link.normal_x[i],      link.normal_y[i],
            link.offset[i] - reach, link.offset[i] + reach};
}

/// Do the lanes' regions cover each other so well that one search may serve them all?
inline bool close_together(const SweptLink& link, const BoxQuery& joint, LaneMask of) {
    float sum = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
        if ((of >> i & 1) == 0) continue;
        sum += link.high_x[i] - link.low_x[i] + link.high_y[i] - link.low_y[i];
    }
    return joint.high_x - joint.low_x + joint.high_y - joint.low_y <= sum;
}

/// Up to here every box that comes near one of eight chains is compared with all their links.
inline constexpr std::size_t few_boxes = 64;

/// Calls on_hit(box, lanes, first link, number of links) wherever one of these links may meet a box
/// in these lanes; on_hit clears lanes from alive that need no further answer.
template <bool moving, class OnHit>
HWY_INLINE void search_links(const detail::ChainScratch& scratch, const BoxTree& tree,
                             LaneMask& alive, OnHit&& on_hit) {
    const float slack = scratch.slack;
    const auto compare = [&](std::uint32_t entry, std::size_t first, std::size_t count) HWY_ATTR {
        const Target box(tree.nodes[entry / WideNode::width], entry % WideNode::width, slack);
        if (count > 1 && (region_hits(scratch.whole, box) & alive) == 0) return false;
        const LaneMask bits =
            hits<moving>(std::span(scratch.links).subspan(first, count), box) & alive;
        if (bits != 0) on_hit(tree.order[entry], bits, first, count);
        return alive == 0;
    };
    if (alive == 0) return;
    if (tree.order.size() <= few_boxes) {
        query::for_each_candidate(tree, joint_query(scratch.whole, alive, slack),
                                  [&](std::uint32_t entry)
                                      HWY_ATTR { return compare(entry, 0, scratch.links.size()); });
        return;
    }
    for (std::size_t k = 0; k < scratch.links.size() && alive != 0; ++k) {
        const SweptLink& link = scratch.links[k];
        const BoxQuery joint = joint_query(link, alive, slack);
        if (close_together(link, joint, alive)) {
            query::for_each_candidate(
                tree, joint, [&](std::uint32_t entry) HWY_ATTR { return compare(entry, k, 1); });
            continue;
        }
        for (LaneMask rest = alive; rest != 0; rest &= rest - 1) {
            const auto lane = static_cast<std::size_t>(__builtin_ctz(rest));
            query::for_each_candidate(tree, lane_query(link, lane, moving, slack),
                                      [&](std::uint32_t entry) HWY_ATTR {
                                          on_hit(tree.order[entry], 1U << lane, k, std::size_t{1});
                                          return (alive >> lane & 1) == 0;
                                      });
        }
    }
}

}  // namespace asv::geometry::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
