// Kinematics and shape of eight chains; compiled once for every instruction set.
#if defined(ASV_CORE_CHAIN_BATCH_CHAIN_SHAPE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_CORE_CHAIN_BATCH_CHAIN_SHAPE_INL_HPP
#undef ASV_CORE_CHAIN_BATCH_CHAIN_SHAPE_INL_HPP
#else
#define ASV_CORE_CHAIN_BATCH_CHAIN_SHAPE_INL_HPP
#endif

#include <cmath>
#include <limits>

#include <hwy/highway.h>

#include "core/chain/batch/chain_batch.hpp"
#include "core/chain/batch/chain_source-inl.hpp"
#include "core/chain/batch/swept_link.hpp"
#include "geometry/simd/sin_cos-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::core::batch::HWY_NAMESPACE {

using geometry::simd::HWY_NAMESPACE::sin_cos;

/// Walks along the chains in one vector of lanes. What concerns the stretch round a configuration
/// is not computed where the source rests.
///
/// In a stretch, t in [-1, 1], every heading is linear, heading_k + t change_k. So
///  - a point stays within stray of p + t drift, as |p''| <= link sum |lever_k| change_k^2;
///  - link * sum of sines of heading differences makes the closing turns, and link^2 / 2 times the
///  sum
///    over all pairs the area; |f''| is at most the same sum of the squared differences of the
///    changes, so f stays above f - |f'| - |f''| / 2;
///  - the turns are linear themselves.
template <class Source>
class ChainWalk {
  public:
    HWY_INLINE ChainWalk(const ChainLimits& limits, const Source& source,
                         detail::ChainScratch& scratch, std::size_t lane)
        : limits_(limits),
          source_(source),
          scratch_(scratch),
          i_(lane),
          count_(scratch.links.size()),
          min_turn_(limits.min_turn.data()),
          lever_(limits.anchor_lever.empty() ? nullptr : limits.anchor_lever.data()),
          point_x_(scratch.x.data()),
          point_y_(scratch.y.data()),
          direction_x_(scratch.direction_x.data()),
          direction_y_(scratch.direction_y.data()),
          link_(scratch.links.data()) {}

    /// Fills these lanes of the scratch rows; bits from 0 on tell which of them keep all limits but
    /// those that boxes set.
    HWY_INLINE detail::LaneVerdict walk() {
        walk_headings();
        walk_points();
        keep_shape();
        const auto zero = set(0);
        const auto valid = to_bits(hn::Ge(room_, zero));
        if (!moving) return {valid, valid};
        const auto certified = to_bits(hn::Ge(stretch_room_, set(scratch_.rounding)));
        return {certified & valid, valid};
    }

  private:
    static constexpr bool moving = Source::moving;

    /// There is this much room in the middle, and in the stretch it shrinks by at most loss.
    HWY_INLINE void keep(Doubles room, Doubles loss) {
        room_ = hn::Min(room_, room);
        if (moving) stretch_room_ = hn::Min(stretch_room_, hn::Sub(room, loss));
    }

    HWY_INLINE void walk_headings() {
        Doubles heading = source_.at(2, i_);
        last_change_ = source_.change(2, i_);
        for (std::size_t k = 0; k < count_; ++k) {
            const Doubles next = source_.at(2 + k, i_);
            const Doubles change = source_.change(2 + k, i_);
            if (k > 0) {
                const Doubles turn = hn::Sub(next, heading);
                const Doubles loss = hn::Abs(hn::Sub(change, last_change_));
                keep(hn::Sub(turn, set(min_turn_[k - 1])), loss);
                keep(hn::Sub(set(limits_.max_turn), turn), loss);
            }
            heading = next;
            last_change_ = change;
            Doubles sine, cosine;
            sin_cos(Double8(), heading, sine, cosine);
            store(cosine, direction_x_[k], i_);
            store(sine, direction_y_[k], i_);
            if (moving) {
                sum_ = hn::Add(sum_, change);
                sum_of_squares_ = hn::Add(sum_of_squares_, hn::Mul(change, change));
            }
            if (lever_ != nullptr) {
                const double lever = lever_[k];
                advance(limits_.link * lever, std::fabs(lever), cosine, sine, change);
            }
        }
        const Doubles total = hn::Sub(heading, source_.at(2, i_));
        keep(hn::Sub(set(limits_.max_total_turn), total),
             hn::Abs(hn::Sub(last_change_, source_.change(2, i_))));
    }

    /// Goes along a link by length, whereby the sum of |lever| over all links grows by
    /// lever_growth.
    HWY_INLINE void advance(double length, double lever_growth, Doubles cosine, Doubles sine,
                            Doubles change) {
        x_ = hn::Add(x_, hn::Mul(set(length), cosine));
        y_ = hn::Add(y_, hn::Mul(set(length), sine));
        if (!moving) return;
        const Doubles lever = hn::Mul(set(length), change);
        drift_x_ = hn::Sub(drift_x_, hn::Mul(lever, sine));
        drift_y_ = hn::Add(drift_y_, hn::Mul(lever, cosine));
        const Doubles half_growth = set(0.5 * limits_.link * lever_growth);
        stray_ = hn::Add(stray_, hn::Mul(half_growth, hn::Mul(change, change)));
    }

    /// What lies ahead of link k follows it by 1 more than what lies behind.
    HWY_INLINE double lever_growth(std::size_t k) const {
        if (!moving || lever_ == nullptr) return 1;
        const double lever = lever_[k];
        return std::fabs(1 + lever) - std::fabs(lever);
    }

    HWY_INLINE void walk_points() {
        first_x_ = x_ = hn::Add(source_.at(0, i_), x_);
        first_y_ = y_ = hn::Add(source_.at(1, i_), y_);
        first_drift_x_ = drift_x_ = hn::Add(source_.change(0, i_), drift_x_);
        first_drift_y_ = drift_y_ = hn::Add(source_.change(1, i_), drift_y_);
        store_point(0);
        Region start = whole_ = region();
        middle_ = {x_, y_, x_, y_};
        for (std::size_t k = 0; k < count_; ++k) {
            const Doubles cosine = load(direction_x_[k], i_);
            const Doubles sine = load(direction_y_[k], i_);
            const Doubles change = source_.change(2 + k, i_);
            if (k > 0) add_area(cosine, sine, change);
            const Doubles offset = cross(cosine, sine, x_, y_);
            const Doubles half_width = half_width_across(cosine, sine);
            advance(limits_.link, lever_growth(k), cosine, sine, change);
            store_point(k + 1);
            const Region end = region();
            whole_.include(end);
            if (moving) middle_.include({x_, y_, x_, y_});
            start.include(end);
            store_region(start, link_[k]);
            store(hn::Neg(sine), link_[k].normal_x, i_);
            store(cosine, link_[k].normal_y, i_);
            store(offset, link_[k].offset, i_);
            if (moving) {
                store(hn::Max(half_width, half_width_across(cosine, sine)), link_[k].half_width,
                      i_);
            }
            start = end;
        }
        store_region(whole_, scratch_.whole);
    }

    /// What the point sweeps.
    HWY_INLINE Region region() const {
        if (!moving) return {x_, y_, x_, y_};
        const Doubles wide = hn::Add(hn::Abs(drift_x_), stray_);
        const Doubles high = hn::Add(hn::Abs(drift_y_), stray_);
        return {hn::Sub(x_, wide), hn::Sub(y_, high), hn::Add(x_, wide), hn::Add(y_, high)};
    }

    /// How far the point strays from where it is, along the normal of a direction.
    HWY_INLINE Doubles half_width_across(Doubles cosine, Doubles sine) const {
        if (!moving) return set(0);
        return hn::Add(hn::Abs(cross(cosine, sine, drift_x_, drift_y_)), stray_);
    }

    HWY_INLINE void store_point(std::size_t k) {
        store(x_, point_x_[k], i_);
        store(y_, point_y_[k], i_);
    }
    HWY_INLINE void store_region(const Region& region, detail::SweptLink& link) {
        store(region.low_x, link.low_x, i_);
        store(region.low_y, link.low_y, i_);
        store(region.high_x, link.high_x, i_);
        store(region.high_y, link.high_y, i_);
    }

    /// The triangle from the first point to the link that starts here, and its derivative.
    HWY_INLINE void add_area(Doubles cosine, Doubles sine, Doubles change) {
        const Doubles x = hn::Sub(x_, first_x_);
        const Doubles y = hn::Sub(y_, first_y_);
        area_ = hn::Add(area_, cross(x, y, cosine, sine));
        if (!moving) return;
        const Doubles drift_x = hn::Sub(drift_x_, first_drift_x_);
        const Doubles drift_y = hn::Sub(drift_y_, first_drift_y_);
        const Doubles slope = hn::Add(cross(drift_x, drift_y, cosine, sine),
                                      hn::Mul(change, dot(x, y, cosine, sine)));
        area_slope_ = hn::Add(area_slope_, slope);
    }

    /// The sum over all links of (change - change_k)^2.
    HWY_INLINE Doubles spread(Doubles change) const {
        const Doubles links = set(static_cast<double>(count_));
        const Doubles mixed = hn::Sub(hn::Mul(links, change), hn::Mul(set(2), sum_));
        return hn::Add(hn::Mul(change, mixed), sum_of_squares_);
    }

    HWY_INLINE void keep_shape() {
        const std::size_t last = count_ - 1;
        const Doubles cosine = load(direction_x_[last], i_);
        const Doubles sine = load(direction_y_[last], i_);
        const Doubles first_cosine = load(direction_x_[0], i_);
        const Doubles first_sine = load(direction_y_[0], i_);
        const Doubles first_change = source_.change(2, i_);
        const Doubles x = hn::Sub(first_x_, x_);
        const Doubles y = hn::Sub(first_y_, y_);
        const Doubles drift_x = hn::Sub(first_drift_x_, drift_x_);
        const Doubles drift_y = hn::Sub(first_drift_y_, drift_y_);
        const Doubles half_link = set(0.5 * limits_.link);

        const Doubles last_slope = hn::Sub(cross(cosine, sine, drift_x, drift_y),
                                           hn::Mul(last_change_, dot(cosine, sine, x, y)));
        keep(hn::Sub(cross(cosine, sine, x, y), set(limits_.min_last_closing_turn)),
             hn::Add(hn::Abs(last_slope), hn::Mul(half_link, spread(last_change_))));
        const Doubles first_slope =
            hn::Add(cross(drift_x, drift_y, first_cosine, first_sine),
                    hn::Mul(first_change, dot(first_cosine, first_sine, x, y)));
        keep(hn::Sub(cross(x, y, first_cosine, first_sine), set(limits_.min_first_closing_turn)),
             hn::Add(hn::Abs(first_slope), hn::Mul(half_link, spread(first_change))));
        keep(hn::Sub(length(x, y), set(limits_.min_closing_side)),
             hn::Add(length(drift_x, drift_y), hn::Mul(half_link, sum_of_squares_)));

        const Doubles pairs = hn::Sub(hn::Mul(set(static_cast<double>(last + 1)), sum_of_squares_),
                                      hn::Mul(sum_, sum_));
        keep(hn::Sub(hn::Mul(half_link, area_), set(limits_.min_area)),
             hn::Mul(half_link, hn::Add(hn::Abs(area_slope_), hn::Mul(half_link, pairs))));

        room_ = hn::Min(room_, (moving ? middle_ : whole_).room_in(limits_.bounds));
        if (moving) stretch_room_ = hn::Min(stretch_room_, whole_.room_in(limits_.bounds));
    }

    const ChainLimits& limits_;
    const Source& source_;
    detail::ChainScratch& scratch_;
    const std::size_t i_;
    // Copies of what the loops use, as vector stores may alias all that is behind a reference.
    const std::size_t count_;
    const double* const min_turn_;
    const double* const lever_;  ///< null for zeros
    Pack* const point_x_;
    Pack* const point_y_;
    Pack* const direction_x_;
    Pack* const direction_y_;
    detail::SweptLink* const link_;

    Doubles room_ = set(std::numeric_limits<double>::infinity());
    Doubles stretch_room_ = room_;
    Doubles x_ = set(0), y_ = set(0), drift_x_ = set(0), drift_y_ = set(0), stray_ = set(0);
    Doubles first_x_ = x_, first_y_ = y_, first_drift_x_ = x_, first_drift_y_ = y_;
    Doubles last_change_ = x_, sum_ = x_, sum_of_squares_ = x_;
    Doubles area_ = x_, area_slope_ = x_;  // without the factor link / 2
    Region whole_{x_, x_, x_, x_}, middle_ = whole_;
};

}  // namespace asv::core::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
