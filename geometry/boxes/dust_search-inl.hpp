// Segments against the cells of a dust grid; compiled once for every instruction set.
#if defined(ASV_GEOMETRY_BOXES_DUST_SEARCH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_GEOMETRY_BOXES_DUST_SEARCH_INL_HPP
#undef ASV_GEOMETRY_BOXES_DUST_SEARCH_INL_HPP
#else
#define ASV_GEOMETRY_BOXES_DUST_SEARCH_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "geometry/boxes/box_query-inl.hpp"
#include "geometry/boxes/dust_grid.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::detail::HWY_NAMESPACE {

/// Goes through the cells along queries that have a unit normal. Calls visit(box, the query's
/// number) for every box in the grid that a query may reach and for some a step farther; a query
/// for which done(number) holds is given up.
///
/// Centres are compared on the query's normal in whole numbers of sixteen bits, in units of 1/64
/// step: a line in one instruction or two.
template <class Done, class Visit>
class DustSearch {
  public:
    HWY_INLINE DustSearch(const DustGrid& grid, Done done, Visit visit)
        : grid_(grid), per_cell_(1 / grid.cell), done_(done), visit_(visit) {}

    /// Some of what this query finds may be visited later, at the latest by finish().
    HWY_INLINE void add(const BoxQuery& query, std::uint32_t number) {
        if (interval_count_ == max_intervals) {
            look_at_hits();
            interval_count_ = 0;
        }
        Interval& interval = intervals_[interval_count_];
        interval.number = number;
        const double x = query.normal_x, y = query.normal_y;
        interval.normal_x = static_cast<std::int16_t>(std::clamp(x * 0x1p15, -32767.0, 32767.0));
        interval.normal_y = static_cast<std::int16_t>(std::clamp(y * 0x1p15, -32767.0, 32767.0));

        const double offset = x * grid_.low.x + y * grid_.low.y;
        const double half = std::fabs(x) * grid_.half_x + std::fabs(y) * grid_.half_y;
        const double begin = (query.normal_low - offset - half) * per_cell_;
        const double end = (query.normal_high - offset + half) * per_cell_;
        const double low_x = (query.low_x - grid_.low.x - grid_.half_x) * per_cell_ - margin;
        const double low_y = (query.low_y - grid_.low.y - grid_.half_y) * per_cell_ - margin;
        const double high_x = (query.high_x - grid_.low.x + grid_.half_x) * per_cell_ + margin;
        const double high_y = (query.high_y - grid_.low.y + grid_.half_y) * per_cell_ + margin;
        const std::uint32_t columns = grid_.columns, rows = grid_.rows;
        if (std::fabs(y) >= std::fabs(x)) {
            walk({x, y, begin, end, low_x, high_x, low_y, high_y, columns, rows, 1, columns});
        } else {
            walk({y, x, begin, end, low_y, high_y, low_x, high_x, rows, columns, columns, 1});
        }
        ++interval_count_;
    }

    HWY_INLINE void finish() { look_at_hits(); }

  private:
    static constexpr std::uint32_t max_cells = 256, max_hits = 64;
    static constexpr std::uint16_t max_intervals = 64;
    static constexpr double unit = 64 * DustLine::steps;  ///< how many of them a cell has
    static constexpr double margin = 1e-3;  ///< far more than rounding errors, in cells

    /// A query in cells, along the axis a more than along b. Its interval on the normal is that of
    /// the centres, and so is its region.
    struct Band {
        double normal_a, normal_b, begin, end;
        double low_a, high_a, low_b, high_b;
        std::uint32_t count_a, count_b, stride_a, stride_b;
    };

    /// What a query asks of a centre: to be in an interval of this length, in units, on its normal.
    struct Interval {
        std::int16_t normal_x, normal_y;
        std::uint16_t length;
        std::uint32_t number;  ///< of the query
    };

    /// A line of a cell, and where the interval begins from the cell's low corner on, modulo 2^16:
    /// that may let through what is far away, but keeps back nothing.
    struct Cell {
        std::uint32_t line;
        std::uint16_t begin, interval;
    };

    struct Found {
        std::uint32_t box, number;
    };

    /// Where a band's interval begins, from the low corner of cell (a, b) on: begin - unit_a a -
    /// unit_b b, in units.
    struct Origin {
        double begin, unit_a, unit_b;
    };

    /// Writes how long the band's interval is.
    HWY_INLINE Origin begin_interval(const Band& band) {
        // A centre is off by at most half a step, 32 units, on each axis. A product is off by less
        // than one unit, and by less than half of one as the normal is rounded; what is computed
        // here by less than a hundredth; and cutting off two fractions takes less than two.
        const double slack = 6 + 32 * (std::fabs(band.normal_a) + std::fabs(band.normal_b));
        const double length = unit * (band.end - band.begin) + 2 * slack;
        // Of a cell that a wide interval crosses, everything may as well be looked at.
        const bool wide = length > 0xFFFF;
        intervals_[interval_count_].length = wide ? 0xFFFF : static_cast<std::uint16_t>(length);
        return {wide ? 0 : unit * band.begin - slack, wide ? 0 : unit * band.normal_a,
                wide ? 0 : unit * band.normal_b};
    }

    HWY_INLINE void walk(const Band& band) {
        // Within the grid, and less than the count when the fraction is cut off: a margin that is
        // half as large cannot leave out a centre.
        const double low_a = std::max(band.low_a, 0.0), low_b = std::max(band.low_b, 0.0);
        const double high_a = std::min(band.high_a, band.count_a - margin / 2);
        const double high_b = std::min(band.high_b, band.count_b - margin / 2);
        if (!(low_a <= high_a && low_b <= high_b)) return;

        const Origin origin = begin_interval(band);
        const double slope = -band.normal_a / band.normal_b;
        const double side = band.begin / band.normal_b, other_side = band.end / band.normal_b;
        const double low = std::min(side, other_side) + std::min(slope, 0.0) - margin;
        const double high = std::max(side, other_side) + std::max(slope, 0.0) + margin;
        const auto last = static_cast<std::int32_t>(high_a);
        const DustLine* const lines = grid_.lines.data();
        std::uint32_t count = 0;
        const auto put = [&](std::uint32_t at, std::uint32_t line, double where) HWY_ATTR {
            hwy::Prefetch(lines + line);
            const auto whole = static_cast<std::int32_t>(where);
            cells_[at] = {line, static_cast<std::uint16_t>(whole), interval_count_};
        };
        const auto make_room = [&]() HWY_ATTR {
            if (count < max_cells) return;
            look_at_cells(count);
            count = 0;
        };
        for (auto a = static_cast<std::int32_t>(low_a); a <= last; ++a) {
            const double from = std::max(low + slope * a, low_b);
            const double to = std::min(high + slope * a, high_b);
            if (!(from <= to)) continue;
            const auto first_b = static_cast<std::int32_t>(from);
            const auto final_b = static_cast<std::int32_t>(to);
            const std::uint32_t line = static_cast<std::uint32_t>(a) * band.stride_a +
                                       static_cast<std::uint32_t>(first_b) * band.stride_b;
            const double here = origin.begin - origin.unit_a * a - origin.unit_b * first_b;
            // Mostly there are one or two cells: no branch for the second.
            const std::uint32_t second = static_cast<std::uint32_t>(first_b - final_b) >> 31;
            put(count, line, here);
            put(count + 1, line + (band.stride_b & (0U - second)), here - origin.unit_b);
            count += 1 + second;
            make_room();
            for (std::int32_t more = 2; more <= final_b - first_b; ++more) {
                put(count++, line + static_cast<std::uint32_t>(more) * band.stride_b,
                    here - origin.unit_b * more);
                make_room();
            }
        }
        look_at_cells(count);
    }

    using Shorts = hn::CappedTag<std::int16_t, DustLine::width>;
    using Unsigned = hn::RebindToUnsigned<Shorts>;

    /// An interval in vectors.
    class Comparison {
      public:
        HWY_INLINE explicit Comparison(const Interval& interval)
            : normal_x_(hn::Set(Shorts(), interval.normal_x)),
              normal_y_(hn::Set(Shorts(), interval.normal_y)),
              length_(hn::Set(Unsigned(), interval.length)) {}

        /// Is any lane in the interval, those without a centre among them?
        HWY_INLINE bool finds_any(const DustLine& line, std::uint16_t begin) const {
            auto any = inside(line, begin, 0);
            for (std::size_t i = hn::Lanes(u_); i < DustLine::width; i += hn::Lanes(u_)) {
                any = hn::Or(any, inside(line, begin, i));
            }
            return !hn::AllFalse(u_, any);
        }

        /// Which of them are, one to a bit?
        HWY_INLINE std::uint32_t find(const DustLine& line, std::uint16_t begin) const {
            std::uint32_t bits = 0;
            for (std::size_t i = 0; i < DustLine::width; i += hn::Lanes(u_)) {
                bits |= to_bits(u_, inside(line, begin, i)) << i;
            }
            return bits;
        }

      private:
        HWY_INLINE hn::Mask<Unsigned> inside(const DustLine& line, std::uint16_t begin,
                                             std::size_t i) const {
            const auto at = hn::Add(product(line.x, i, normal_x_), product(line.y, i, normal_y_));
            const auto from_begin = hn::Sub(hn::BitCast(u_, at), hn::Set(u_, begin));
            return hn::Eq(hn::Min(from_begin, length_), from_begin);
        }

        template <class Row>
        HWY_INLINE hn::Vec<Shorts> product(const Row& row, std::size_t i,
                                           hn::Vec<Shorts> normal) const {
            const hn::Rebind<std::uint8_t, Shorts> bytes;
            const auto steps = hn::PromoteTo(Shorts(), hn::Load(bytes, row.data() + i));
            return hn::MulFixedPoint15(hn::ShiftLeft<6>(steps), normal);
        }

        static constexpr Unsigned u_{};
        hn::Vec<Shorts> normal_x_, normal_y_;
        hn::Vec<Unsigned> length_;
    };

    HWY_INLINE void look_at_cells(std::uint32_t count) {
        const Comparison comparison(intervals_[interval_count_]);
        const DustLine* const lines = grid_.lines.data();
        std::uint32_t hit_count = hit_count_;
        for (std::uint32_t i = 0; i < count; ++i) {
            Cell cell = cells_[i];
            for (;;) {
                // A branch would be as good as random.
                hits_[hit_count] = cell;
                hit_count += comparison.finds_any(lines[cell.line], cell.begin) ? 1U : 0U;
                if (hit_count == max_hits) {
                    hit_count_ = hit_count;
                    look_at_hits();
                    hit_count = 0;
                }
                if (!lines[cell.line].goes_on()) break;
                cell.line = grid_.further[cell.line];
            }
        }
        hit_count_ = hit_count;
    }

    /// All of it is asked for before any of it is used, as it is seldom in a cache.
    HWY_NOINLINE void look_at_hits() {
        for (std::uint32_t i = 0; i < hit_count_; ++i) hwy::Prefetch(&grid_.first[hits_[i].line]);
        std::uint32_t found_count = 0;
        for (std::uint32_t i = 0; i < hit_count_; ++i) {
            const auto [line, begin, number] = hits_[i];
            const Interval& interval = intervals_[number];
            const std::uint32_t first = grid_.first[line], count = grid_.first[line + 1] - first;
            std::uint32_t bits = Comparison(interval).find(grid_.lines[line], begin);
            bits &= (1U << count) - 1;
            for (; bits != 0; bits &= bits - 1) {
                const std::uint32_t box = first + static_cast<std::uint32_t>(__builtin_ctz(bits));
                hwy::Prefetch(&grid_.boxes[box]);
                found_[found_count++] = {box, interval.number};
            }
        }
        for (std::uint32_t i = 0; i < found_count; ++i) {
            const auto [box, number] = found_[i];
            if (!done_(number)) visit_(grid_.boxes[box], number);
        }
        hit_count_ = 0;
    }

    const DustGrid& grid_;
    const double per_cell_;
    Done done_;
    Visit visit_;
    std::uint16_t interval_count_ = 0;
    std::uint32_t hit_count_ = 0;
    std::array<Interval, max_intervals> intervals_;
    std::array<Cell, max_cells + 1> cells_;
    std::array<Cell, max_hits> hits_;
    std::array<Found, max_hits * DustLine::max_boxes> found_;
};

}  // namespace asv::geometry::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
