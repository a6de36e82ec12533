#pragma once

#include <cstddef>
#include <vector>

#include "core/bounds/gates/chain_cells.hpp"
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

    /// Precondition: as of ChainCells.
    EmptyRegion(const Problem& problem, const Box& middle);

    /// Looks at so many cells at most, some microseconds each; the number is reduced by those that
    /// it has looked at. While the answer is unknown it can go on.
    Answer examine(std::size_t& cells);

  private:
    ChainCells cells_;
    std::vector<ChainCell> waiting_;  ///< the last is next, so that there are never many
};

}  // namespace asv::core
