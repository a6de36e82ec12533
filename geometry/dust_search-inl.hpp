// Segments against the cells of a dust grid; compiled once for every instruction set.
#if defined(ASV_GEOMETRY_DUST_SEARCH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_GEOMETRY_DUST_SEARCH_INL_HPP
#undef ASV_GEOMETRY_DUST_SEARCH_INL_HPP
#else
#define ASV_GEOMETRY_DUST_SEARCH_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "asv/geometry/box_query-inl.hpp"
#include "asv/geometry/dust_grid.hpp"

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
        number_ = number;
        const double x = query.normal_x, y = query.normal_y;
        normal_x_ = static_cast<std::int16_t>(std::clamp(x * 0x1p15, -32767.0, 32767.0));
        normal_y_ = static_cast<std::int16_t>(std::clamp(y * 0x1p15, -32767.0, 32767.0));

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
    }

    HWY_INLINE void finish() { look_at_hits(); }

  private:
    static constexpr std::uint32_t most_cells = 256, enough_hits = 64;
    static constexpr double unit = 64 * DustLine::steps;  ///< how many of them a cell has
    static constexpr double margin = 1e-3;  ///< far more than rounding errors, in cells

    /// A query in cells, along the axis a more than along b. Its interval on the normal is that of
    /// the centres, and so is its region.
    struct Band {
        double normal_a, normal_b, begin, end;
        double low_a, high_a, low_b, high_b;
        std::uint32_t count_a, count_b, stride_a, stride_b;
    };

    /// A cell, and where the query's interval begins on the normal, from the cell's low corner on.
    struct Cell {
        std::uint32_t line;
        std::int32_t begin;
    };

    /// Boxes of a line, one to a bit, that a query may reach.
    struct Hit {
        std::uint32_t line, bits, number;
    };

    struct Found {
        std::uint32_t box, number;
    };

    HWY_INLINE void walk(const Band& band) {
        // Within the grid, and less than the count when the fraction is cut off: a margin that is
        // half as large cannot leave out a centre.
        const double low_a = std::max(band.low_a, 0.0), low_b = std::max(band.low_b, 0.0);
        const double high_a = std::min(band.high_a, band.count_a - margin / 2);
        const double high_b = std::min(band.high_b, band.count_b - margin / 2);
        if (!(low_a <= high_a && low_b <= high_b)) return;

        // A centre is off by at most half a step, 32 units, on each axis. A product is off by less
        // than one unit, and by less than half of one as the normal is rounded; what is computed
        // here by less than a hundredth; and cutting off the fraction takes less than one.
        const double slack = 5 + 32 * (std::fabs(band.normal_a) + std::fabs(band.normal_b));
        // Of a cell that a wider interval crosses, everything may as well be looked at.
        const bool wide = band.end - band.begin > 1;
        const double unit_a = wide ? 0 : unit * band.normal_a;
        const double unit_b = wide ? 0 : unit * band.normal_b;
        const double begin = wide ? -0x1p15 : unit * band.begin - slack;
        length_ =
            wide ? 1 << 16 : static_cast<std::int32_t>(unit * (band.end - band.begin) + 2 * slack);

        const double slope = -band.normal_a / band.normal_b;
        const double side = band.begin / band.normal_b, other_side = band.end / band.normal_b;
        const double low = std::min(side, other_side) + std::min(slope, 0.0) - margin;
        const double high = std::max(side, other_side) + std::max(slope, 0.0) + margin;
        const auto last = static_cast<std::int32_t>(high_a);
        for (auto a = static_cast<std::int32_t>(low_a); a <= last; ++a) {
            const double from = std::max(low + slope * a, low_b);
            const double to = std::min(high + slope * a, high_b);
            if (!(from <= to)) continue;
            const auto first_b = static_cast<std::int32_t>(from);
            const auto final_b = static_cast<std::int32_t>(to);
            const std::uint32_t line = static_cast<std::uint32_t>(a) * band.stride_a +
                                       static_cast<std::uint32_t>(first_b) * band.stride_b;
            const double here = begin - unit_a * a - unit_b * first_b;
            // Mostly there are one or two cells: no branch for the second.
            const std::uint32_t second = static_cast<std::uint32_t>(first_b - final_b) >> 31;
            put(0, line, here);
            put(1, line + (band.stride_b & (0U - second)), here - unit_b);
            cell_count_ += 1 + second;
            for (std::int32_t more = 2; more <= final_b - first_b; ++more) {
                put(0, line + static_cast<std::uint32_t>(more) * band.stride_b,
                    here - unit_b * more);
                if (++cell_count_ >= most_cells - 1) look_at_cells();
            }
            if (cell_count_ >= most_cells - 1) look_at_cells();
        }
        look_at_cells();
    }

    HWY_INLINE void put(std::uint32_t ahead, std::uint32_t line, double begin) {
        hwy::Prefetch(&grid_.lines[line]);
        cells_[cell_count_ + ahead] = {line, static_cast<std::int32_t>(begin)};
    }

    HWY_INLINE void look_at_cells() {
        const Shorts d;
        const auto x = hn::Set(d, normal_x_), y = hn::Set(d, normal_y_);
        for (std::uint32_t i = 0; i < cell_count_; ++i) {
            auto [line, begin] = cells_[i];
            const auto low = hn::Set(d, to_short(begin));
            const auto high = hn::Set(d, to_short(begin + length_));
            for (;;) {
                const std::uint32_t bits = between(grid_.lines[line], x, y, low, high);
                // A branch would be as good as random.
                hits_[hit_count_] = {line, bits, number_};
                hit_count_ += bits != 0 ? 1 : 0;
                if (hit_count_ == enough_hits) look_at_hits();
                const std::uint32_t further = grid_.lines[line].further();
                if (further == 0) break;
                line = grid_.columns * grid_.rows + further - 1;
            }
        }
        cell_count_ = 0;
    }

    using Shorts = hn::CappedTag<std::int16_t, DustLine::width>;
    using ShortVec = hn::Vec<Shorts>;

    static std::int16_t to_short(std::int32_t value) {
        return static_cast<std::int16_t>(std::clamp(value, -(1 << 15), (1 << 15) - 1));
    }

    /// Bit l: in lane l is a centre, if any, whose place on the normal is from low to high.
    HWY_INLINE static std::uint32_t between(const DustLine& line, ShortVec normal_x,
                                            ShortVec normal_y, ShortVec low, ShortVec high) {
        const Shorts d;
        const hn::Rebind<std::uint8_t, Shorts> bytes;
        const auto product = [&](const auto& row, std::size_t i, ShortVec normal) HWY_ATTR {
            const auto steps = hn::PromoteTo(d, hn::Load(bytes, row.data() + i));
            return hn::MulFixedPoint15(hn::ShiftLeft<6>(steps), normal);
        };
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < DustLine::width; i += hn::Lanes(d)) {
            const auto at = hn::Add(product(line.x, i, normal_x), product(line.y, i, normal_y));
            const auto outside = hn::Or(hn::Lt(at, low), hn::Gt(at, high));
            bits |= to_bits(d, hn::Not(outside)) << i;
        }
        return bits;
    }

    /// All of it is asked for before any of it is used, as it is seldom in a cache.
    HWY_NOINLINE void look_at_hits() {
        for (std::uint32_t i = 0; i < hit_count_; ++i) hwy::Prefetch(&grid_.first[hits_[i].line]);
        std::uint32_t found_count = 0;
        for (std::uint32_t i = 0; i < hit_count_; ++i) {
            auto [line, bits, number] = hits_[i];
            const std::uint32_t first = grid_.first[line];
            bits &= (1U << (grid_.first[line + 1] - first)) - 1;
            for (; bits != 0; bits &= bits - 1) {
                const std::uint32_t box = first + static_cast<std::uint32_t>(__builtin_ctz(bits));
                hwy::Prefetch(&grid_.boxes[box]);
                found_[found_count++] = {box, number};
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
    std::uint32_t number_ = 0;
    std::int16_t normal_x_ = 0, normal_y_ = 0;
    std::int32_t length_ = 0;  ///< of the query's interval
    std::uint32_t cell_count_ = 0, hit_count_ = 0;
    std::array<Cell, most_cells + 1> cells_;
    std::array<Hit, enough_hits> hits_;
    std::array<Found, enough_hits * DustLine::most_boxes> found_;
};

}  // namespace asv::geometry::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
