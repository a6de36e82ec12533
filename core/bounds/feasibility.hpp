#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/model/problem.hpp"

namespace asv::core {

/// Why a problem has no solution.
enum class Infeasibility {
    none,  ///< nothing found: most often there is a solution
    /// The chain cannot enclose the area that is required, whatever its shape.
    no_area,
    /// Start and goal turn in opposite directions: on the way the area would have to be zero.
    opposite_orientation,
    /// An ASV's start and goal are in different components of the free space.
    separated,
    /// The middle of the chain cannot get from its start to its goal but through straight corridors
    /// that are too low for the chain.
    corridor_too_low,
    /// The middle of the chain cannot get from its start to its goal but through gates between
    /// obstacles where no chain can have its middle.
    gates_closed,
    /// The chain would have to turn, on its way, where there is no room for it.
    no_room_to_turn,
    /// Either of the two, by Reading::intended. There is no path for a chain that moves
    /// continuously and does not squeeze between obstacles that touch; the validator might accept
    /// one that does or that jumps over a thin obstacle.
    separated_as_intended
};

struct Feasibility {
    Infeasibility cause = Infeasibility::none;
    std::optional<std::size_t> asv;  ///< 0-based, where one ASV is the reason
    std::string reason;              ///< one sentence with 1-based numbers; empty when none
    /// Where corridors or gates are the reason: the places in them that the middle of the chain
    /// cannot be at. Where it has no room to turn: the places of its middle where it would have to.
    std::vector<Box> closed = {};

    /// Is it proven that the validator accepts no path, not even one that jumps or squeezes?
    bool proven_infeasible() const {
        return cause != Infeasibility::none && cause != Infeasibility::separated_as_intended;
    }
};

/// Can a chain of so many ASVs enclose the area that is required at all? Start and goal may be
/// invalid.
Feasibility check_area(const Problem& problem);

/// Do start and goal turn in one direction? Precondition: both are valid states.
Feasibility check_orientation(const Problem& problem);

/// Are start and goal of every ASV, or of the point, in one component of the free space, and start
/// and goal of the middle of the chain in one of what is left of it by corridors that are too low
/// for the chain as a whole (see find_low_corridors)? Nothing is found for an arm. Takes up to a
/// second among very many obstacles, or for 100 ASVs. Precondition: both are valid states.
Feasibility check_separation(const Problem& problem);

/// Has a chain room on its ways, to pass gates between obstacles and to turn (see PassageCheck)?
/// Nothing is found for other bodies, for more than 12 ASVs or 1000 obstacles. Takes up to half a
/// second or so; solve() goes on for longer. Precondition: both are valid states.
Feasibility check_passages(const Problem& problem);

/// Looks for a proof that the problem has no solution, the cheapest first, by all of the above but
/// check_passages(). Every cause is proven as its description says, whatever primitive steps a path
/// is made of. Precondition: start and goal are valid states, except that two ASVs never are, for
/// want of area.
Feasibility check_feasibility(const Problem& problem);

}  // namespace asv::core
