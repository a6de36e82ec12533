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
        : low_x(node.side[WideNode::low_x][lane] - margin),
          low_y(node.side[WideNode::low_y][lane] - margin),
          high_x(node.side[WideNode::high_x][lane] + margin),
          high_y(node.side[WideNode::high_y][lane] + margin),
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
inline constexpr std::size_t few_boxes = 256;

/// Where links of eight chains may meet boxes. on_hit(box, lanes, first link, number of links) is
/// called wherever one of these links may meet the box in one of these lanes, and clears lanes from
/// alive that need no further answer.
template <bool moving, class OnHit>
class LinkSearch {
  public:
    HWY_INLINE LinkSearch(const detail::ChainScratch& scratch, const BoxTree& tree, LaneMask& alive,
                          OnHit& on_hit)
        : scratch_(scratch), tree_(tree), alive_(alive), on_hit_(on_hit) {}

    HWY_INLINE void search() {
        if (alive_ == 0) return;
        if (tree_.order.size() <= few_boxes) {
            search_jointly(joint_query(scratch_.whole, alive_, scratch_.slack), 0,
                           scratch_.links.size());
            return;
        }
        for (std::size_t k = 0; k < scratch_.links.size() && alive_ != 0; ++k) {
            const BoxQuery joint = joint_query(scratch_.links[k], alive_, scratch_.slack);
            if (close_together(scratch_.links[k], joint, alive_)) {
                search_jointly(joint, k, 1);
            } else {
                search_lanes(k);
            }
        }
    }

  private:
    /// All boxes near any of the lanes are compared with all of them.
    HWY_INLINE void search_jointly(const BoxQuery& joint, std::size_t first, std::size_t count) {
        query::for_each_candidate(
            tree_, std::span(&joint, 1), [&](std::uint32_t) { return alive_ == 0; },
            [&](const WideNode& node, std::uint32_t lane, std::uint32_t, std::uint32_t box)
                HWY_ATTR {
                    const Target target(node, lane, scratch_.slack);
                    if (count > 1 && (region_hits(scratch_.whole, target) & alive_) == 0) return;
                    const auto links = std::span(scratch_.links).subspan(first, count);
                    const LaneMask bits = hits<moving>(links, target) & alive_;
                    if (bits != 0) on_hit_(box, bits, first, count);
                });
    }

    HWY_INLINE void search_lanes(std::size_t link) {
        std::array<BoxQuery, lanes> queries;
        for (std::size_t i = 0; i < lanes; ++i) {
            queries[i] = lane_query(scratch_.links[link], i, moving, scratch_.slack);
        }
        query::for_each_candidate(
            tree_, queries, [&](std::uint32_t lane) { return (alive_ >> lane & 1) == 0; },
            [&](const WideNode&, std::uint32_t, std::uint32_t lane, std::uint32_t box)
                HWY_ATTR { on_hit_(box, 1U << lane, link, std::size_t{1}); });
    }

    const detail::ChainScratch& scratch_;
    const BoxTree& tree_;
    LaneMask& alive_;
    OnHit& on_hit_;
};

}  // namespace asv::geometry::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
