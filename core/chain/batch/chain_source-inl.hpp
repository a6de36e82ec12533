// Vectors of eight chains' numbers and where they come from; compiled once for every instruction
// set.
#if defined(ASV_CORE_CHAIN_BATCH_CHAIN_SOURCE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_CORE_CHAIN_BATCH_CHAIN_SOURCE_INL_HPP
#undef ASV_CORE_CHAIN_BATCH_CHAIN_SOURCE_INL_HPP
#else
#define ASV_CORE_CHAIN_BATCH_CHAIN_SOURCE_INL_HPP
#endif

#include <cstddef>
#include <cstdint>
#include <span>

#include <hwy/highway.h>

#include "core/chain/batch/chain_batch.hpp"
#include "core/chain/batch/swept_link.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::core::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Double8 = hn::CappedTag<double, lanes>;
using Doubles = hn::Vec<Double8>;

HWY_INLINE Doubles set(double value) {
    return hn::Set(Double8(), value);
}
HWY_INLINE Doubles load(const Pack& pack, std::size_t i) {
    return hn::Load(Double8(), pack.lane.data() + i);
}
HWY_INLINE void store(Doubles value, Pack& pack, std::size_t i) {
    hn::Store(value, Double8(), pack.lane.data() + i);
}
HWY_INLINE void store(Doubles value, detail::SweptLink::Row& row, std::size_t i) {
    const hn::Rebind<float, Double8> d;
    hn::Store(hn::DemoteTo(d, value), d, row.data() + i);
}
HWY_INLINE std::uint32_t to_bits(hn::Mask<Double8> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Double8(), mask, bits);
    return bits[0];
}
HWY_INLINE Doubles cross(Doubles ax, Doubles ay, Doubles bx, Doubles by) {
    return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
}
HWY_INLINE Doubles dot(Doubles ax, Doubles ay, Doubles bx, Doubles by) {
    return hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by));
}
HWY_INLINE Doubles length(Doubles x, Doubles y) {
    return hn::Sqrt(dot(x, y, x, y));
}

/// Eight configurations as the caller wrote them.
struct Resting {
    static constexpr bool moving = false;
    std::span<const Pack> rows;

    HWY_INLINE Doubles at(std::size_t row, std::size_t i) const { return load(rows[row], i); }
    HWY_INLINE Doubles change(std::size_t, std::size_t) const { return set(0); }
};

struct Moving {
    static constexpr bool moving = true;
    const Stretches& line;

    HWY_INLINE Doubles at(std::size_t row, std::size_t i) const {
        return hn::Add(set(line.from[row]), hn::Mul(load(line.middle, i), set(line.step[row])));
    }
    /// From the middle of the stretch to its end.
    HWY_INLINE Doubles change(std::size_t row, std::size_t i) const {
        return hn::Mul(load(line.half_length, i), set(line.step[row]));
    }
};

/// The smallest box round some points, for every lane.
struct Region {
    Doubles low_x, low_y, high_x, high_y;

    HWY_INLINE void include(const Region& other) {
        low_x = hn::Min(low_x, other.low_x);
        low_y = hn::Min(low_y, other.low_y);
        high_x = hn::Max(high_x, other.high_x);
        high_y = hn::Max(high_y, other.high_y);
    }

    /// How far it stays from the sides of a box that holds it.
    HWY_INLINE Doubles room_in(const Box& box) const {
        return hn::Min(hn::Min(hn::Sub(low_x, set(box.low.x)), hn::Sub(low_y, set(box.low.y))),
                       hn::Min(hn::Sub(set(box.high.x), high_x), hn::Sub(set(box.high.y), high_y)));
    }
};

}  // namespace asv::core::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
