// One query against the eight boxes of a node; compiled once for every instruction set.
#if defined(ASV_GEOMETRY_BOXES_BOX_QUERY_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_GEOMETRY_BOXES_BOX_QUERY_INL_HPP
#undef ASV_GEOMETRY_BOXES_BOX_QUERY_INL_HPP
#else
#define ASV_GEOMETRY_BOXES_BOX_QUERY_INL_HPP
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "geometry/boxes/box_tree.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Eight floats, in as many vectors as the instruction set needs.
using Float8 = hn::CappedTag<float, WideNode::width>;
using Floats = hn::Vec<Float8>;
/// Sixteen, likewise.
using Float16 = hn::CappedTag<float, Leaf::width>;

/// A leaf together with what its steps refer to.
struct FramedLeaf {
    const Leaf& leaf;
    const LeafFrame& frame;
};

/// The sides of several boxes, one box to a lane.
template <class V>
struct Sides {
    V low_x, low_y, high_x, high_y;
};

HWY_INLINE Floats load_side(const WideNode& node, std::uint32_t side, std::size_t i) {
    return hn::Load(Float8(), node.side[side].data() + i);
}

HWY_INLINE Sides<Floats> load_sides(Float8, const WideNode& node, std::size_t i) {
    return {load_side(node, low_x, i), load_side(node, low_y, i), load_side(node, high_x, i),
            load_side(node, high_y, i)};
}

HWY_INLINE Sides<hn::Vec<Float16>> load_sides(Float16 d, const FramedLeaf& framed, std::size_t i) {
    const auto unpack = [&](std::uint32_t side, float low, float step) HWY_ATTR {
        const hn::Rebind<std::uint8_t, Float16> bytes;
        const hn::Rebind<std::int32_t, Float16> integers;
        const auto steps = hn::Load(bytes, framed.leaf.side[side].data() + i);
        return hn::Add(hn::Mul(hn::ConvertTo(d, hn::PromoteTo(integers, steps)), hn::Set(d, step)),
                       hn::Set(d, low));
    };
    const auto& [x, y, step_x, step_y] = framed.frame;
    return {unpack(low_x, x, step_x), unpack(low_y, y, step_y), unpack(high_x, x, step_x),
            unpack(high_y, y, step_y)};
}

/// The ends of the boxes' shadows on the query's normal: far >= near. Nothing is fused, here and
/// wherever else a proof depends on it, so that what is proven does not depend on the processor.
template <class V>
struct Shadow {
    V near, far;
};

HWY_INLINE Shadow<Floats> shadow(Float8 d, const WideNode& node, const Sides<Floats>&,
                                 std::size_t i, const BoxQuery& query) {
    // Chosen by arithmetic, as the signs of the normals are as good as random.
    const std::uint32_t right = query.normal_x >= 0 ? 2 : 0;
    const std::uint32_t up = query.normal_y >= 0 ? 2 : 0;
    const auto x = hn::Set(d, query.normal_x);
    const auto y = hn::Set(d, query.normal_y);
    const auto far_y = load_side(node, low_y + up, i);
    const auto near_y = load_side(node, high_y - up, i);
    return {hn::Add(hn::Mul(x, load_side(node, high_x - right, i)), hn::Mul(y, near_y)),
            hn::Add(hn::Mul(x, load_side(node, low_x + right, i)), hn::Mul(y, far_y))};
}

template <class V>
HWY_INLINE Shadow<V> shadow(Float16 d, const FramedLeaf&, const Sides<V>& sides, std::size_t,
                            const BoxQuery& query) {
    const auto x = hn::Set(d, query.normal_x);
    const auto y = hn::Set(d, query.normal_y);
    const auto right = hn::Ge(x, hn::Zero(d));
    const auto up = hn::Ge(y, hn::Zero(d));
    const auto far_y = hn::IfThenElse(up, sides.high_y, sides.low_y);
    const auto near_y = hn::IfThenElse(up, sides.low_y, sides.high_y);
    const auto near_x = hn::IfThenElse(right, sides.low_x, sides.high_x);
    const auto far_x = hn::IfThenElse(right, sides.high_x, sides.low_x);
    return {hn::Add(hn::Mul(x, near_x), hn::Mul(y, near_y)),
            hn::Add(hn::Mul(x, far_x), hn::Mul(y, far_y))};
}

template <class D>
HWY_INLINE std::uint32_t to_bits(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; 8 * i < hn::Lanes(d); ++i) {
        bits |= static_cast<std::uint32_t>(bytes[i]) << 8 * i;
    }
    return bits;
}

/// Bit l: something in lane l may have what the query asks for.
HWY_INLINE std::uint32_t candidates(const WideNode& node, const BoxQuery& query) {
    const Float8 d;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < WideNode::width; i += hn::Lanes(d)) {
        const auto sides = load_sides(d, node, i);
        const auto in_x = hn::And(hn::Le(sides.low_x, hn::Set(d, query.high_x)),
                                  hn::Ge(sides.high_x, hn::Set(d, query.low_x)));
        const auto in_y = hn::And(hn::Le(sides.low_y, hn::Set(d, query.high_y)),
                                  hn::Ge(sides.high_y, hn::Set(d, query.low_y)));
        const auto [near, far] = shadow(d, node, sides, i, query);
        // Overflow leaves NaN, which must not count as apart.
        const auto across = hn::Or(hn::Gt(near, hn::Set(d, query.normal_high)),
                                   hn::Lt(far, hn::Set(d, query.normal_low)));
        bits |= to_bits(d, hn::AndNot(across, hn::And(in_x, in_y))) << i;
    }
    return bits;
}

/// Bit l: the box in lane l, if there is one, may have what the query asks for. Overflow leaves
/// NaN, which must not count as apart.
HWY_INLINE std::uint32_t candidates(const FramedLeaf& leaf, const BoxQuery& query) {
    const Float16 d;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < Leaf::width; i += hn::Lanes(d)) {
        const auto sides = load_sides(d, leaf, i);
        const auto beside = hn::Or(hn::Gt(sides.low_x, hn::Set(d, query.high_x)),
                                   hn::Lt(sides.high_x, hn::Set(d, query.low_x)));
        const auto above = hn::Or(hn::Gt(sides.low_y, hn::Set(d, query.high_y)),
                                  hn::Lt(sides.high_y, hn::Set(d, query.low_y)));
        const auto [near, far] = shadow(d, leaf, sides, i, query);
        const auto across = hn::Or(hn::Gt(near, hn::Set(d, query.normal_high)),
                                   hn::Lt(far, hn::Set(d, query.normal_low)));
        bits |= to_bits(d, hn::Not(hn::Or(across, hn::Or(beside, above)))) << i;
    }
    return bits;
}

/// Has the box what the query asks for? By the box as it is, not by a leaf's steps.
inline bool reaches(const Box& box, const BoxQuery& query) {
    const double x = query.normal_x, y = query.normal_y;
    const double near =
        x * (x >= 0 ? box.low.x : box.high.x) + y * (y >= 0 ? box.low.y : box.high.y);
    const double far =
        x * (x >= 0 ? box.high.x : box.low.x) + y * (y >= 0 ? box.high.y : box.low.y);
    const bool region = (box.low.x <= query.high_x) & (box.high.x >= query.low_x) &
                        (box.low.y <= query.high_y) & (box.high.y >= query.low_y);
    return region & !((near > query.normal_high) | (far < query.normal_low));
}

}  // namespace asv::geometry::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
