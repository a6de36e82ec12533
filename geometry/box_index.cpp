#include "asv/geometry/box_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "asv/geometry/box_index.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "asv/geometry/box_query-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
namespace inl = detail::HWY_NAMESPACE;
using detail::BoxQuery;
using detail::BoxSearch;
using detail::BoxTree;
using detail::NodeId;
using detail::WideNode;

std::uint32_t Advance(const BoxTree& tree, BoxSearch& search) {
    const BoxQuery query = search.query;
    while (search.open_count > 0) {
        const NodeId id = search.open[--search.open_count];
        std::uint32_t bits = inl::candidates(tree.node(id), query);
        std::uint32_t count = 0;
        for (; bits != 0; bits &= bits - 1) {
            const std::uint32_t lane =
                id.index * WideNode::width + static_cast<std::uint32_t>(__builtin_ctz(bits));
            if (id.level == 0) {
                search.found[count++] = tree.order[lane];
            } else {
                search.open[search.open_count++] = {id.level - 1, lane};
            }
        }
        if (count > 0) return count;
    }
    return 0;
}

/// Below the distance of the query's segment to each box, infinity in lanes without a box.
HWY_INLINE void lower_bounds(const WideNode& node, const BoxQuery& query, float* bounds) {
    const inl::Float8 d;
    const auto zero = hn::Zero(d);
    const auto most = hn::Set(d, std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < WideNode::width; i += hn::Lanes(d)) {
        const auto low_x = inl::load_side(node, WideNode::low_x, i);
        const auto low_y = inl::load_side(node, WideNode::low_y, i);
        const auto high_x = inl::load_side(node, WideNode::high_x, i);
        const auto high_y = inl::load_side(node, WideNode::high_y, i);
        const auto x = hn::Max(zero, hn::Max(hn::Sub(low_x, hn::Set(d, query.high_x)),
                                             hn::Sub(hn::Set(d, query.low_x), high_x)));
        const auto y = hn::Max(zero, hn::Max(hn::Sub(low_y, hn::Set(d, query.high_y)),
                                             hn::Sub(hn::Set(d, query.low_y), high_y)));
        // sqrt(x^2 + y^2) >= (x + y) / sqrt(2) cannot overflow on the way as the squares could.
        const auto diagonal = hn::Mul(hn::Set(d, 0.7071067F), hn::Add(hn::Min(x, most), y));
        auto bound = hn::Max(hn::Max(x, y), diagonal);
        const auto [near, far] = inl::shadow(node, i, query);
        const auto normal = hn::Max(hn::Sub(near, hn::Set(d, query.normal_high)),
                                    hn::Sub(hn::Set(d, query.normal_low), far));
        bound = hn::IfThenElse(hn::Gt(normal, bound), normal, bound);
        bound = hn::Mul(hn::Min(bound, most), hn::Set(d, 1 - 0x1p-20F));
        const auto infinity = hn::Set(d, std::numeric_limits<float>::infinity());
        hn::StoreU(hn::IfThenElse(hn::Le(low_x, high_x), bound, infinity), d, bounds + i);
    }
}

/// A node or a box and how near it can be; the nearest first.
struct Near {
    float bound;
    NodeId id;
};

/// Appends the lanes that may be nearer than best, the nearest last; returns the new end.
HWY_INLINE Near* push_lanes(const WideNode& node, NodeId id, const BoxQuery& query, double best,
                            Near* end) {
    float bounds[WideNode::width];
    lower_bounds(node, query, bounds);
    Near* const begin = end;
    for (std::uint32_t lane = 0; lane < WideNode::width; ++lane) {
        if (!(static_cast<double>(bounds[lane]) < best)) continue;
        Near* at = end++;
        for (; at != begin && at[-1].bound < bounds[lane]; --at) *at = at[-1];
        *at = {bounds[lane], {id.level, id.index * WideNode::width + lane}};
    }
    return end;
}

double Nearest(const BoxTree& tree, std::span<const Box> boxes, const Segment& segment,
               const BoxQuery& query, double best) {
    Near open[BoxTree::most_open + WideNode::width];
    Near* end = open;
    if (!tree.nodes.empty()) *end++ = {0, {tree.levels(), 0}};
    while (end != open && best > 0) {
        const Near next = *--end;
        if (!(static_cast<double>(next.bound) < best)) continue;
        if (next.id.level == 0) {
            best = std::min(best, distance(segment, boxes[tree.order[next.id.index]]));
        } else {
            const NodeId id{next.id.level - 1, next.id.index};
            end = push_lanes(tree.node(id), id, query, best, end);
        }
    }
    return best;
}

}  // namespace
}  // namespace asv::geometry::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asv::geometry {

namespace {

HWY_EXPORT(Advance);
HWY_EXPORT(Nearest);

// Shorter segments are treated as their bounding boxes; their squares lose digits to underflow.
constexpr double min_length = 1e-140;
constexpr double max_float = std::numeric_limits<float>::max();

detail::BoxSearch from_roots(const detail::BoxTree& tree, const detail::BoxQuery& query) {
    detail::BoxSearch search;
    search.query = query;
    const std::uint32_t level = tree.search_level();
    for (std::uint32_t i = tree.node_count(level); i-- > 0;) {
        search.open[search.open_count++] = {level, i};
    }
    return search;
}

detail::BoxQuery region(const Box& box) {
    return {detail::rounded_down(box.low.x),
            detail::rounded_down(box.low.y),
            detail::rounded_up(box.high.x),
            detail::rounded_up(box.high.y),
            0,
            0,
            -std::numeric_limits<float>::infinity(),
            std::numeric_limits<float>::infinity()};
}

// Any axis separates, so the rounding of the normal to single precision needs no allowance, as long
// as its length stays below 1 + 2^-22. The shadow of a box with coordinates up to M is computed
// with two products and a sum, off by at most 2^-24 (|x| + |y| + |x + y|) <= 2^-22 M; the shadow of
// the segment, in double precision, by less than 2^-40 of its coordinates. The same slack covers
// the error of geometry::distance, by which the boxes within the radius are finally chosen.
detail::BoxQuery region(const Segment& segment, double radius, double reach) {
    const auto& [a, b] = segment;
    const double largest =
        std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
    const double slack = 0x1p-21 * reach + 0x1p-40 * largest + std::numeric_limits<float>::min();
    const double margin = radius * (1 + 0x1p-20) + slack;
    detail::BoxQuery query = region(grown(bounds(segment), margin));
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (!(length > min_length && length < max_float)) return query;
    query.normal_x = static_cast<float>(-dy / length);
    query.normal_y = static_cast<float>(dx / length);
    const auto [low, high] = std::minmax(
        {query.normal_x * a.x + query.normal_y * a.y, query.normal_x * b.x + query.normal_y * b.y});
    query.normal_low = detail::rounded_down(low - margin);
    query.normal_high = detail::rounded_up(high + margin);
    return query;
}

}  // namespace

detail::BoxSearch BoxIndex::begin(const Box& query) const {
    return from_roots(tree_, region(query));
}

detail::BoxSearch BoxIndex::begin(const Segment& query, double radius) const {
    return from_roots(tree_, region(query, radius, tree_.reach));
}

std::uint32_t BoxIndex::advance(detail::BoxSearch& search) const {
    return HWY_DYNAMIC_DISPATCH(Advance)(tree_, search);
}

double BoxIndex::distance(const Segment& segment, double cutoff) const {
    return HWY_DYNAMIC_DISPATCH(Nearest)(tree_, boxes_, segment, region(segment, 0, tree_.reach),
                                         cutoff);
}

}  // namespace asv::geometry
#endif  // HWY_ONCE
