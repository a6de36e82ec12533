#pragma once

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "core/chain/batch/swept_link.hpp"
#include "geometry/boxes/box_index.hpp"
#include "geometry/primitives.hpp"
#include "geometry/simd/pack.hpp"

namespace asv::core::batch {

/// What a chain of points joined by links of one length has to keep. The polygon is closed by the
/// closing side, from the last point back to the first. For counter-clockwise chains; mirror
/// others.
struct ChainLimits {
    double link = 1;                    ///< length of every link, > 0
    Box bounds{{0, 0}, {1, 1}};         ///< closed; holds every point
    double min_area = 0;                ///< signed area of the closed polygon
    double min_first_closing_turn = 0;  ///< cross(closing side, direction of the first link)
    double min_last_closing_turn = 0;   ///< cross(direction of the last link, closing side)
    double min_closing_side = 0;        ///< length of the closing side
    std::vector<double> min_turn;  ///< radians, from each link to the next; one fewer than links
    double max_turn = std::numbers::pi;            ///< of every turn
    double max_total_turn = 2 * std::numbers::pi;  ///< from the first to the last heading
    /// What the first two coordinates refer to: the first point stands at (x, y) + link * (sum of
    /// anchor_lever[k] * direction of link k). Empty for zeros: (x, y) is the first point.
    std::vector<double> anchor_lever;
};

/// Eight stretches of one straight line from + t * step: lane l is |t - middle[l]| <=
/// half_length[l].
struct Stretches {
    std::span<const double> from, step;  ///< a configuration and a difference: x, y, headings
    Pack middle, half_length;
};

/// Two answers for eight stretches of one motion.
struct StretchVerdict {
    LaneMask certified;       ///< every configuration of the stretch keeps all limits: proven
    LaneMask midpoint_valid;  ///< the configuration in its middle keeps them; holds where certified
};

/// Checks chains eight at a time, one to a SIMD lane: forward kinematics, bounds, turns, closing
/// turns, area and links against boxes. A verdict on configurations is exact for the positions that
/// the kinematics yield in double precision, and these have the same bits on every processor.
///
/// Holds scratch memory: one object for each thread; calls allocate nothing. Limits and boxes are
/// referred to and must outlive it.
class ChainBatch {
  public:
    /// Precondition: links >= 1; the sizes within limits fit.
    ChainBatch(std::size_t links, const ChainLimits& limits, const BoxIndex& boxes);

    std::size_t links() const { return scratch_.links.size(); }

    /// Which of eight configurations keep all limits; a link that touches a box does not.
    /// Configurations: x, y, then the heading of every link in radians, not wrapped, |heading| <
    /// 2^20. Precondition: rows.size() == links() + 2.
    LaneMask valid(std::span<const Pack> rows);

    /// Conservative: certified is never said of a stretch that holds an invalid configuration, and
    /// not of one that comes nearer to a box than about 2e-6, to another limit than about 1e-12, of
    /// the largest coordinate. The positions are those of the middles.
    StretchVerdict certify(const Stretches& stretches);

    /// Positions of the points of the last call's (middle) configurations, links() + 1 rows each.
    std::span<const Pack> x() const { return scratch_.x; }
    std::span<const Pack> y() const { return scratch_.y; }

  private:
    const ChainLimits& limits_;
    const BoxIndex& boxes_;
    detail::ChainScratch scratch_;
};

}  // namespace asv::core::batch
