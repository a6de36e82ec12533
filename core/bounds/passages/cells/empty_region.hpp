#pragma once

#include <cstddef>
#include <vector>

#include "core/bounds/passages/cells/chain_cells.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// The question whether a rectangle is empty: no state that the validator accepts, of the problem's
/// chain turning left, has its middle there. Cells of the configuration space are halved until each
/// is proven to hold no state (branch and bound), or one is too small to be halved.
class EmptyRegion {
  public:
    enum class Answer {
        unknown,  ///< not yet
        empty,    ///< proven
        may_not_be
    };

    /// most_cells: to look at in all, some microseconds each; if they do not suffice, the rectangle
    /// may not be empty. Precondition: as of ChainCells.
    EmptyRegion(const Problem& problem, const Box& middle, std::size_t most_cells);

    /// The same of the states with a broom of such a heading alone.
    EmptyRegion(const Problem& problem, const Box& middle, const BroomHeading& heading,
                std::size_t most_cells);

    /// Looks at so many cells at most; the number is reduced by those that it has looked at. While
    /// the answer is unknown it can go on.
    Answer examine(std::size_t& cells);

  private:
    ChainCells cells_;
    std::vector<ChainCell> waiting_;  ///< the last is next, so that there are never many
    std::size_t left_;                ///< of most_cells
};

}  // namespace asv::core
