// One query against the eight boxes of a node; compiled once for every instruction set.
#if defined(ASV_GEOMETRY_BOX_QUERY_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_GEOMETRY_BOX_QUERY_INL_HPP
#undef ASV_GEOMETRY_BOX_QUERY_INL_HPP
#else
#define ASV_GEOMETRY_BOX_QUERY_INL_HPP
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "asv/geometry/box_tree.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Eight floats, in as many vectors as the instruction set needs.
using Float8 = hn::CappedTag<float, WideNode::width>;
using Floats = hn::Vec<Float8>;

/// The ends of the boxes' shadows on the query's normal: far >= near.
struct Shadow {
    Floats near, far;
};

HWY_INLINE Shadow shadow(const WideNode& node, std::size_t i, const BoxQuery& query) {
    const Float8 d;
    const bool right = query.normal_x >= 0;
    const bool up = query.normal_y >= 0;
    const auto x = hn::Set(d, query.normal_x);
    const auto y = hn::Set(d, query.normal_y);
    const auto far_x = hn::Load(d, (right ? node.high_x : node.low_x).data() + i);
    const auto far_y = hn::Load(d, (up ? node.high_y : node.low_y).data() + i);
    const auto near_x = hn::Load(d, (right ? node.low_x : node.high_x).data() + i);
    const auto near_y = hn::Load(d, (up ? node.low_y : node.high_y).data() + i);
    return {hn::MulAdd(x, near_x, hn::Mul(y, near_y)), hn::MulAdd(x, far_x, hn::Mul(y, far_y))};
}

template <class D>
HWY_INLINE std::uint32_t to_bits(D d, hn::Mask<D> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return bits[0];
}

/// Bit l: the box in lane l may have what the query asks for.
HWY_INLINE std::uint32_t candidates(const WideNode& node, const BoxQuery& query) {
    const Float8 d;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < WideNode::width; i += hn::Lanes(d)) {
        const auto in_x =
            hn::And(hn::Le(hn::Load(d, node.low_x.data() + i), hn::Set(d, query.high_x)),
                    hn::Ge(hn::Load(d, node.high_x.data() + i), hn::Set(d, query.low_x)));
        const auto in_y =
            hn::And(hn::Le(hn::Load(d, node.low_y.data() + i), hn::Set(d, query.high_y)),
                    hn::Ge(hn::Load(d, node.high_y.data() + i), hn::Set(d, query.low_y)));
        const auto [near, far] = shadow(node, i, query);
        // Overflow leaves NaN, which must not count as apart.
        const auto apart = hn::Or(hn::Gt(near, hn::Set(d, query.normal_high)),
                                  hn::Lt(far, hn::Set(d, query.normal_low)));
        bits |= to_bits(d, hn::AndNot(apart, hn::And(in_x, in_y))) << i;
    }
    return bits;
}

/// Calls visit(lane of level 0) for the boxes that the query may reach until it returns true.
template <class Visit>
HWY_INLINE void for_each_candidate(const BoxTree& tree, const BoxQuery& query, Visit&& visit) {
    NodeId open[BoxTree::most_open];
    std::uint32_t open_count = 0;
    const std::uint32_t level = tree.search_level();
    for (std::uint32_t i = tree.node_count(level); i-- > 0;) open[open_count++] = {level, i};
    while (open_count > 0) {
        const NodeId id = open[--open_count];
        std::uint32_t bits = candidates(tree.node(id), query);
        for (; bits != 0; bits &= bits - 1) {
            const std::uint32_t lane =
                id.index * WideNode::width + static_cast<std::uint32_t>(__builtin_ctz(bits));
            if (id.level > 0) {
                open[open_count++] = {id.level - 1, lane};
            } else if (visit(lane)) {
                return;
            }
        }
    }
}

}  // namespace asv::geometry::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
