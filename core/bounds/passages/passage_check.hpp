#pragma once

#include <cstddef>
#include <optional>

#include "core/bounds/feasibility.hpp"
#include "core/bounds/passages/cells/turned_left.hpp"
#include "core/bounds/passages/gate_check.hpp"
#include "core/bounds/passages/turn_check.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// Looks for a proof that a chain has no room somewhere on each of its ways, by cells of its
/// configuration space: first that its middle cannot pass gates, then that it cannot turn as it
/// would have to. It works in portions, so that a search can go on beside it.
class PassageCheck {
  public:
    /// Precondition: the problem has bounds, and valid ends.
    explicit PassageCheck(const Problem& problem);

    /// Goes on for some number of cells, a few microseconds each. There is no cause as long as
    /// nothing is proven.
    Feasibility work(std::size_t cells);

    /// Is there nothing left to look for?
    bool finished() const { return !gates_ && !turns_; }

  private:
    Feasibility no_room_to_turn() const;

    TurnedLeft turned_;
    std::optional<GateCheck> gates_;
    std::optional<TurnCheck> turns_;
};

}  // namespace asv::core
