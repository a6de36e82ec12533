#include "asv/geometry/batch/segment_box_batch.hpp"

#include <cassert>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "asv/geometry/batch/segment_box_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "asv/geometry/orientation.hpp"
#include "asv/geometry/segment_box.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::batch::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// At most eight pairs at a time, so that a mask fits in a byte.
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

struct Side {
    M left, right;  ///< surely; neither where rounding could decide
};

/// The filter of geometry::orientation, lane by lane, with the same operations.
HWY_INLINE Side side(V ax, V ay, V bx, V by, V cx, V cy) {
    const D d;
    const V left = hn::Mul(hn::Sub(ax, cx), hn::Sub(by, cy));
    const V right = hn::Mul(hn::Sub(ay, cy), hn::Sub(bx, cx));
    const V determinant = hn::Sub(left, right);
    const V size = hn::Add(hn::Abs(left), hn::Abs(right));
    const V error = hn::Add(hn::Mul(hn::Set(d, orientation_filter.relative), size),
                            hn::Set(d, orientation_filter.absolute));
    return {hn::Gt(determinant, error), hn::Gt(hn::Neg(determinant), error)};
}

/// Bits of the pairs that surely meet, and of those that surely do not.
struct Certain {
    std::uint32_t meeting, apart;
};

HWY_INLINE std::uint32_t to_bits(M mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(D(), mask, bits);
    return bits[0];
}

HWY_INLINE M within(V value, V low, V high) {
    return hn::And(hn::Ge(value, low), hn::Le(value, high));
}

HWY_INLINE Certain compare(const Segments& segments, const Boxes& boxes, std::size_t i) {
    const D d;
    const V ax = hn::LoadU(d, &segments.a_x[i]), ay = hn::LoadU(d, &segments.a_y[i]);
    const V bx = hn::LoadU(d, &segments.b_x[i]), by = hn::LoadU(d, &segments.b_y[i]);
    const V low_x = hn::LoadU(d, &boxes.low_x[i]), low_y = hn::LoadU(d, &boxes.low_y[i]);
    const V high_x = hn::LoadU(d, &boxes.high_x[i]), high_y = hn::LoadU(d, &boxes.high_y[i]);

    const M beside = hn::Or(hn::Lt(hn::Max(ax, bx), low_x), hn::Gt(hn::Min(ax, bx), high_x));
    const M above = hn::Or(hn::Lt(hn::Max(ay, by), low_y), hn::Gt(hn::Min(ay, by), high_y));
    const M empty = hn::Or(hn::Gt(low_x, high_x), hn::Gt(low_y, high_y));
    const M regions_apart = hn::Or(empty, hn::Or(beside, above));

    // The diagonal of the box that spans its shadow on the normal of the segment.
    const M falling = hn::Xor(hn::Lt(ax, bx), hn::Lt(ay, by));
    const Side left = side(ax, ay, bx, by, low_x, hn::IfThenElse(falling, low_y, high_y));
    const Side right = side(ax, ay, bx, by, high_x, hn::IfThenElse(falling, high_y, low_y));
    const M one_side = hn::Or(hn::And(left.left, right.left), hn::And(left.right, right.right));
    const M split = hn::Or(hn::And(left.left, right.right), hn::And(left.right, right.left));

    const M straight = hn::Or(hn::Eq(ax, bx), hn::Eq(ay, by));
    const M inside = hn::Or(hn::And(within(ax, low_x, high_x), within(ay, low_y, high_y)),
                            hn::And(within(bx, low_x, high_x), within(by, low_y, high_y)));
    const M meeting = hn::Or(hn::Or(straight, inside), split);
    return {to_bits(hn::AndNot(regions_apart, meeting)), to_bits(hn::Or(regions_apart, one_side))};
}

void Meets(const Segments& segments, const Boxes& boxes, std::span<std::uint8_t> result) {
    const std::size_t step = hn::Lanes(D());
    const auto exactly = [&](std::size_t i) {
        return meets(
            Segment{{segments.a_x[i], segments.a_y[i]}, {segments.b_x[i], segments.b_y[i]}},
            Box{{boxes.low_x[i], boxes.low_y[i]}, {boxes.high_x[i], boxes.high_y[i]}});
    };
    std::size_t i = 0;
    for (; i + step <= result.size(); i += step) {
        const auto [meeting, apart] = compare(segments, boxes, i);
        for (std::size_t lane = 0; lane < step; ++lane) {
            const bool certain = ((meeting | apart) >> lane & 1) != 0;
            const bool met = certain ? (meeting >> lane & 1) != 0 : exactly(i + lane);
            result[i + lane] = met ? 1 : 0;
        }
    }
    for (; i < result.size(); ++i) result[i] = exactly(i);
}

}  // namespace
}  // namespace asv::geometry::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asv::geometry::batch {

namespace {
HWY_EXPORT(Meets);
}

void meets(const Segments& segments, const Boxes& boxes, std::span<std::uint8_t> result) noexcept {
    assert(segments.a_x.size() == result.size() && boxes.low_x.size() == result.size());
    HWY_DYNAMIC_DISPATCH(Meets)(segments, boxes, result);
}

}  // namespace asv::geometry::batch
#endif  // HWY_ONCE
