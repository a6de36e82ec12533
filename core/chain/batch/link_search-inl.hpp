// Links of eight chains against many boxes; compiled once for every instruction set.
#if defined(ASV_CORE_CHAIN_BATCH_LINK_SEARCH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_CORE_CHAIN_BATCH_LINK_SEARCH_INL_HPP
#undef ASV_CORE_CHAIN_BATCH_LINK_SEARCH_INL_HPP
#else
#define ASV_CORE_CHAIN_BATCH_LINK_SEARCH_INL_HPP
#endif

#include <algorithm>
#include <span>

#include <hwy/highway.h>

#include "core/chain/batch/swept_link.hpp"
#include "geometry/boxes/box_query-inl.hpp"
#include "geometry/boxes/dust_search-inl.hpp"
#include "geometry/boxes/joint_search-inl.hpp"
#include "geometry/simd/pack.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::core::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace query = geometry::detail::HWY_NAMESPACE;
using detail::GrownBox;
using detail::SweptLink;
using geometry::detail::BoxQuery;
using geometry::detail::BoxTree;
using query::Float8;
using query::Floats;

HWY_INLINE hn::Mask<Float8> regions_apart(const SweptLink& link, const GrownBox& box,
                                          std::size_t i) {
    const Float8 d;
    return hn::Or(hn::Or(hn::Gt(hn::Load(d, link.low_x.data() + i), hn::Set(d, box.high_x)),
                         hn::Lt(hn::Load(d, link.high_x.data() + i), hn::Set(d, box.low_x))),
                  hn::Or(hn::Gt(hn::Load(d, link.low_y.data() + i), hn::Set(d, box.high_y)),
                         hn::Lt(hn::Load(d, link.high_y.data() + i), hn::Set(d, box.low_y))));
}

/// Bit l: some of the links may meet the box in lane l.
template <bool moving>
HWY_INLINE LaneMask hits(std::span<const SweptLink> links, const GrownBox& box, float slack) {
    const Float8 d;
    const auto centre_x = hn::Set(d, box.centre_x), centre_y = hn::Set(d, box.centre_y);
    const auto half_x = hn::Set(d, box.half_x), half_y = hn::Set(d, box.half_y);
    LaneMask bits = 0;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
        auto all_apart = hn::FirstN(d, lanes);
        for (const SweptLink& link : links) {
            const auto x = hn::Load(d, link.normal_x.data() + i);
            const auto y = hn::Load(d, link.normal_y.data() + i);
            const auto offset = hn::Load(d, link.offset.data() + i);
            const auto between =
                hn::Add(hn::Mul(y, centre_y), hn::Sub(hn::Mul(x, centre_x), offset));
            auto most = hn::Set(d, slack);
            if (moving) most = hn::Add(most, hn::Load(d, link.half_width.data() + i));
            most = hn::Add(hn::Mul(hn::Abs(y), half_y), hn::Add(hn::Mul(hn::Abs(x), half_x), most));
            const auto apart = hn::Or(regions_apart(link, box, i), hn::Gt(hn::Abs(between), most));
            all_apart = hn::And(all_apart, apart);
        }
        bits |= query::to_bits(d, hn::Not(all_apart)) << i;
    }
    return bits;
}

/// Bit l: the region in lane l may meet the box.
HWY_INLINE LaneMask region_hits(const SweptLink& region, const GrownBox& box) {
    const Float8 d;
    LaneMask bits = 0;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
        bits |= query::to_bits(d, hn::Not(regions_apart(region, box, i))) << i;
    }
    return bits;
}

/// The least number of a row among the lanes that are asked for, infinity if there are none.
HWY_INLINE float least(const SweptLink::Row& row, LaneMask of) {
    const Float8 d;
    const auto infinity = hn::Set(d, std::numeric_limits<float>::infinity());
    auto least = infinity;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
        const std::uint8_t bits[8] = {static_cast<std::uint8_t>(of >> i)};
        const auto values = hn::Load(d, row.data() + i);
        least = hn::Min(least, hn::IfThenElse(hn::LoadMaskBits(d, bits), values, infinity));
    }
    return hn::GetLane(hn::MinOfLanes(d, least));
}

HWY_INLINE float greatest(const SweptLink::Row& row, LaneMask of) {
    const Float8 d;
    const auto lowest = hn::Set(d, -std::numeric_limits<float>::infinity());
    auto greatest = lowest;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
        const std::uint8_t bits[8] = {static_cast<std::uint8_t>(of >> i)};
        const auto values = hn::Load(d, row.data() + i);
        greatest = hn::Max(greatest, hn::IfThenElse(hn::LoadMaskBits(d, bits), values, lowest));
    }
    return hn::GetLane(hn::MaxOfLanes(d, greatest));
}

/// The smallest region that holds those of the lanes that are asked for.
HWY_INLINE BoxQuery joint_query(const SweptLink& link, LaneMask of, float slack) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {least(link.low_x, of) - slack,
            least(link.low_y, of) - slack,
            greatest(link.high_x, of) + slack,
            greatest(link.high_y, of) + slack,
            0,
            0,
            -infinity,
            infinity};
}

inline BoxQuery lane_query(const SweptLink& link, std::size_t i, bool moving, float slack) {
    const float half_width = slack + (moving ? link.half_width[i] : 0);
    return {link.low_x[i] - slack,       link.low_y[i] - slack,      link.high_x[i] + slack,
            link.high_y[i] + slack,      link.normal_x[i],           link.normal_y[i],
            link.offset[i] - half_width, link.offset[i] + half_width};
}

/// Do the lanes' regions cover each other so well that one search should serve them all?
inline bool close_together(const SweptLink& link, const BoxQuery& joint, LaneMask of) {
    float sum = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
        if ((of >> i & 1) == 0) continue;
        sum += link.high_x[i] - link.low_x[i] + link.high_y[i] - link.low_y[i];
    }
    return 2 * (joint.high_x - joint.low_x + joint.high_y - joint.low_y) <= sum;
}

/// Where links of eight chains may meet boxes. on_hit(box, lanes, first link, number of links) is
/// called wherever one of these links may meet the box in one of these lanes, and clears lanes from
/// alive that need no further answer.
template <bool moving, class OnHit>
class LinkSearch {
  public:
    HWY_INLINE LinkSearch(const detail::ChainScratch& scratch, const BoxIndex& boxes,
                          LaneMask& alive, OnHit& on_hit)
        : scratch_(scratch),
          dust_(boxes.dust()),
          tree_(boxes.beside_dust()),
          alive_(alive),
          on_hit_(on_hit) {}

    HWY_INLINE void search() {
        search_tree();
        if (!dust_.empty() && alive_ != 0) search_dust();
    }

  private:
    HWY_INLINE void search_tree() {
        if (tree_.order.size() <= detail::few_boxes) {
            search_few();
            return;
        }
        const auto grown = [&](std::uint32_t i) {
            return detail::grown(tree_.boxes[i], scratch_.slack);
        };
        for (std::size_t k = 0; k < scratch_.links.size() && alive_ != 0; ++k) {
            if (!search_jointly(scratch_.links[k], k, 1, grown)) search_lanes(k);
        }
    }

    HWY_INLINE void search_few() {
        const std::size_t links = scratch_.links.size();
        const bool worth_culling = scratch_.few.size() > lanes;
        const auto few = [&](std::uint32_t i) -> const GrownBox& { return scratch_.few[i]; };
        if (worth_culling && search_jointly(scratch_.whole, 0, links, few)) return;
        for (std::size_t i = 0; i < scratch_.few.size() && alive_ != 0; ++i) {
            compare(scratch_.few[i], tree_.boxes[i], 0, links);
        }
    }

    HWY_INLINE void compare(const GrownBox& grown, const Box& box, std::size_t first,
                            std::size_t count) {
        if (count > 1 && (region_hits(scratch_.whole, grown) & alive_) == 0) return;
        const auto links = std::span(scratch_.links).subspan(first, count);
        const LaneMask bits = hits<moving>(links, grown, scratch_.slack) & alive_;
        if (bits != 0) on_hit_(box, bits, first, count);
    }

    /// Where the lanes' regions cover each other well, compares all boxes near any of them, as
    /// grown by grow(i), with all lanes. Returns whether it did.
    template <class Grow>
    HWY_INLINE bool search_jointly(const SweptLink& region, std::size_t first, std::size_t count,
                                   Grow grow) {
        const BoxQuery joint = joint_query(region, alive_, scratch_.slack);
        if (!close_together(region, joint, alive_)) return false;
        query::for_each_candidate(
            tree_, std::span(&joint, 1), [&](std::uint32_t) { return alive_ == 0; },
            [&](std::uint32_t i, std::uint32_t)
                HWY_ATTR { compare(grow(i), tree_.boxes[i], first, count); });
        return true;
    }

    HWY_INLINE void search_lanes(std::size_t link) {
        std::array<BoxQuery, lanes> queries;
        for (std::size_t i = 0; i < lanes; ++i) {
            queries[i] = lane_query(scratch_.links[link], i, moving, scratch_.slack);
        }
        query::for_each_candidate(
            tree_, queries, [&](std::uint32_t lane) { return (alive_ >> lane & 1) == 0; },
            [&](std::uint32_t i, std::uint32_t lane) HWY_ATTR {
                const bool in_steps = !tree_.leaves.empty();
                if (in_steps && !query::reaches(tree_.boxes[i], queries[lane])) return;
                on_hit_(tree_.boxes[i], 1U << lane, link, std::size_t{1});
            });
    }

    HWY_INLINE void search_dust() {
        const auto done = [&](std::uint32_t number) { return (alive_ >> number % lanes & 1) == 0; };
        const auto visit = [&](const Box& box, std::uint32_t number) HWY_ATTR {
            const std::size_t link = number / lanes, lane = number % lanes;
            const BoxQuery reached = lane_query(scratch_.links[link], lane, moving, scratch_.slack);
            if (query::reaches(box, reached)) on_hit_(box, 1U << lane, link, std::size_t{1});
        };
        query::DustSearch<decltype(done), decltype(visit)> search(dust_, done, visit);
        for (std::uint32_t number = 0; number < scratch_.links.size() * lanes; ++number) {
            if (done(number)) continue;
            search.add(
                lane_query(scratch_.links[number / lanes], number % lanes, moving, scratch_.slack),
                number);
        }
        search.finish();
    }

    const detail::ChainScratch& scratch_;
    const geometry::detail::DustGrid& dust_;
    const BoxTree& tree_;
    LaneMask& alive_;
    OnHit& on_hit_;
};

}  // namespace asv::core::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
