#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/bounds/passages/cells/broom_sector.hpp"
#include "core/model/problem.hpp"

/// Cells of the configuration space of a chain, each with a range for every coordinate, and what is
/// certain of all chains in one.

namespace asv::core {

/// Chains of more ASVs have too many cells.
inline constexpr std::size_t most_asvs_in_cells = 12;

/// The chains whose middle (see middle_of_chain) is in a rectangle, and each of whose brooms has
/// its heading, in radians, in an interval. The headings run on beyond pi: from one broom to the
/// next they grow by the turn.
struct ChainCell {
    Box middle;
    std::array<Interval, most_asvs_in_cells - 1> headings;
};

/// That a broom has its heading in an interval, or differs from it by a multiple of 2 pi.
struct BroomHeading {
    std::size_t broom;
    Interval heading;  ///< radians, from -pi to 3 pi
};

/// The cells of a problem's chains that turn left and have their middle in one rectangle.
class ChainCells {
  public:
    /// Precondition: a chain of 3 to most_asvs_in_cells ASVs.
    ChainCells(const Problem& problem, const Box& middle);

    /// The one of all chains with their middle in the rectangle.
    const ChainCell& all() const { return all_; }

    /// Those of the chains in it one of whose brooms has such a heading, in a few cells.
    std::vector<ChainCell> with_heading(const BroomHeading& wanted) const;

    /// Is it proven that no state in the cell is one that the validator accepts? Else the cell may
    /// have been narrowed to where such states can be.
    ///
    /// Four reasons are known: the headings do not grow from broom to broom, or by more than 2 pi
    /// in all; there is no room for the area; the closing side would have to turn right; one broom
    /// meets one obstacle, or an ASV is out of bounds, in every state of the cell.
    bool holds_no_state(ChainCell& cell) const;

    /// Two cells that hold all chains of this one; none when it is too small to be worth it.
    std::optional<std::pair<ChainCell, ChainCell>> halves(const ChainCell& cell) const;

  private:
    /// A broom, or half of one, outwards from the middle of the chain.
    struct Link {
        std::size_t broom;
        double share;  ///< of the broom; negative where it leads against its heading
    };
    using Sectors = std::span<const BroomSector>;

    void make_arms();
    bool narrow(ChainCell& cell) const;
    bool lacks_area(Sectors sectors) const;
    bool turns_right_at_an_end(Sectors sectors) const;
    bool is_blocked(const Box& middle, Sectors sectors) const;

    std::size_t brooms_;
    double turn_tolerance_;                  ///< slightly more than the validator's, radians
    double shortest_, longest_;              ///< a broom
    double required_area_;                   ///< slightly less than the validator asks for
    Box bounds_;                             ///< of the ASVs, tolerance included
    std::vector<Box> obstacles_;             ///< within reach, shrunk
    std::array<std::vector<Link>, 2> arms_;  ///< from the middle to either end
    ChainCell all_;
};

}  // namespace asv::core
