#include "geometry/boxes/box_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/boxes/box_index.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geometry/boxes/box_query-inl.hpp"
#include "geometry/simd/dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
namespace inl = detail::HWY_NAMESPACE;
using detail::BoxQuery;
using detail::BoxSearch;
using detail::BoxTree;
using detail::Leaf;
using detail::NodeId;
using detail::WideNode;

/// Writes down which of the boxes from first on, one to a bit, the query reaches; returns how many.
HWY_INLINE std::uint32_t write_down(const BoxTree& tree, std::uint32_t first, std::uint32_t bits,
                                    BoxSearch& search) {
    std::uint32_t count = 0;
    for (; bits != 0; bits &= bits - 1) {
        const std::uint32_t box = first + static_cast<std::uint32_t>(__builtin_ctz(bits));
        if (inl::reaches(tree.boxes[box], search.query)) search.found[count++] = tree.order[box];
    }
    return count;
}

std::uint32_t Advance(const BoxTree& tree, BoxSearch& search) {
    const BoxQuery query = search.query;
    const std::uint32_t lowest = tree.leaves.empty() ? 1 : 0;
    while (search.open_count > 0) {
        const auto [level, index] = search.open[--search.open_count];
        const std::uint32_t first = index * (level == 0 ? Leaf::width : WideNode::width);
        std::uint32_t bits = level == 0
                                 ? inl::candidates({tree.leaves[index], tree.frame(index)}, query)
                                 : inl::candidates(tree.node({level, index}), query);
        if (level == lowest) {
            const std::uint32_t count = write_down(tree, first, bits, search);
            if (count > 0) return count;
            continue;
        }
        for (; bits != 0; bits &= bits - 1) {
            const std::uint32_t child = first + static_cast<std::uint32_t>(__builtin_ctz(bits));
            search.open[search.open_count++] = {level - 1, child};
        }
    }
    return 0;
}

/// Below the distance of the query's segment to each box; anything in lanes without a box.
template <class D, class Node>
HWY_INLINE void lower_bounds(D d, const Node& node, std::uint32_t width, const BoxQuery& query,
                             float* bounds) {
    const auto zero = hn::Zero(d);
    const auto most = hn::Set(d, std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < width; i += hn::Lanes(d)) {
        const auto sides = inl::load_sides(d, node, i);
        const auto x = hn::Max(zero, hn::Max(hn::Sub(sides.low_x, hn::Set(d, query.high_x)),
                                             hn::Sub(hn::Set(d, query.low_x), sides.high_x)));
        const auto y = hn::Max(zero, hn::Max(hn::Sub(sides.low_y, hn::Set(d, query.high_y)),
                                             hn::Sub(hn::Set(d, query.low_y), sides.high_y)));
        // sqrt(x^2 + y^2) >= (x + y) / sqrt(2) cannot overflow on the way as the squares could.
        const auto diagonal = hn::Mul(hn::Set(d, 0.7071067F), hn::Add(hn::Min(x, most), y));
        auto bound = hn::Max(hn::Max(x, y), diagonal);
        const auto [near, far] = inl::shadow(d, node, sides, i, query);
        const auto normal = hn::Max(hn::Sub(near, hn::Set(d, query.normal_high)),
                                    hn::Sub(hn::Set(d, query.normal_low), far));
        bound = hn::IfThenElse(hn::Gt(normal, bound), normal, bound);
        bound = hn::Mul(hn::Min(bound, most), hn::Set(d, 1 - 0x1p-20F));
        hn::StoreU(bound, d, bounds + i);
    }
}

/// A leaf or a node, or with level 0 a box, and how near it can be.
struct Near {
    float bound;
    NodeId above;  ///< one level too high, so that there is room for boxes
};

/// The boxes nearest to a segment: a depth-first search, the nearest first.
class NearestSearch {
  public:
    HWY_INLINE NearestSearch(const BoxTree& tree, const BoxQuery& query)
        : tree_(tree), query_(query) {}

    HWY_INLINE double run(std::span<const Box> boxes, const Segment& segment, double best) {
        if (!tree_.nodes.empty()) *end_++ = {0, {tree_.levels(), 0}};
        while (end_ != open_ && best > 0) {
            const auto [bound, above] = *--end_;
            if (bound >= best) continue;
            if (above.level == 0) {
                best = std::min(best, distance(segment, boxes[tree_.order[above.index]]));
            } else if (above.level == 1) {
                open_leaf(above.index, best);
            } else {
                open_node({above.level - 1, above.index}, best);
            }
        }
        return best;
    }

  private:
    HWY_INLINE void open_leaf(std::uint32_t leaf, double best) {
        float bounds[Leaf::width] = {};
        const detail::LeafFrame frame = tree_.frame(leaf);
        // Steps that overflow tell nothing.
        if (std::isfinite(frame.step_x) && std::isfinite(frame.step_y)) {
            lower_bounds(inl::Float16(), inl::FramedLeaf{tree_.leaves[leaf], frame}, Leaf::width,
                         query_, bounds);
        }
        push(bounds, 0, leaf * Leaf::width, tree_.order.size(), best);
    }

    HWY_INLINE void open_node(NodeId id, double best) {
        float bounds[WideNode::width];
        lower_bounds(inl::Float8(), tree_.node(id), WideNode::width, query_, bounds);
        const std::uint32_t first = id.index * WideNode::width;
        if (id.level > 1) {
            push(bounds, id.level, first, tree_.node_count(id.level - 1), best);
        } else if (tree_.leaves.empty()) {
            push(bounds, 0, first, tree_.order.size(), best);
        } else {
            push(bounds, 1, first, tree_.leaves.size(), best);
        }
    }

    /// Appends those that exist and may be nearer than best, the nearest last.
    template <std::size_t width>
    HWY_INLINE void push(const float (&bounds)[width], std::uint32_t level, std::uint32_t first,
                         std::size_t end, double best) {
        const Near* const begin = end_;
        const std::size_t count = std::min(width, end - first);
        for (std::uint32_t lane = 0; lane < count; ++lane) {
            if (bounds[lane] >= best) continue;
            Near* at = end_++;
            for (; at != begin && at[-1].bound < bounds[lane]; --at) *at = at[-1];
            *at = {bounds[lane], {level, first + lane}};
        }
    }

    const BoxTree& tree_;
    const BoxQuery& query_;
    Near open_[BoxTree::max_open + Leaf::width];
    Near* end_ = open_;
};

double Nearest(const BoxTree& tree, std::span<const Box> boxes, const Segment& segment,
               const BoxQuery& query, double best) {
    return NearestSearch(tree, query).run(boxes, segment, best);
}

}  // namespace
}  // namespace asv::geometry::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asv::geometry {

namespace {

ASV_SIMD_EXPORT(Advance);
ASV_SIMD_EXPORT(Nearest);

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
detail::BoxQuery region(const Segment& segment, double radius, double largest_of_tree) {
    const auto& [a, b] = segment;
    const double largest =
        std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
    const double slack =
        0x1p-21 * largest_of_tree + 0x1p-40 * largest + std::numeric_limits<float>::min();
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
    return from_roots(tree_, region(query, radius, tree_.largest_coordinate));
}

std::uint32_t BoxIndex::advance(detail::BoxSearch& search) const {
    return ASV_SIMD_DISPATCH(Advance)(tree_, search);
}

const detail::DustGrid& BoxIndex::dust() const {
    std::call_once(dust_->made, [this] { dust_->grid = detail::build_dust_grid(boxes_); });
    return dust_->grid;
}

double BoxIndex::distance(const Segment& segment, double cutoff) const {
    return ASV_SIMD_DISPATCH(Nearest)(tree_, boxes_, segment,
                                      region(segment, 0, tree_.largest_coordinate), cutoff);
}

}  // namespace asv::geometry
#endif  // HWY_ONCE
