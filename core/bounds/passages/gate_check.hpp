#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/bounds/feasibility.hpp"
#include "core/bounds/passages/cells/empty_region.hpp"
#include "core/bounds/passages/cells/turned_left.hpp"
#include "core/bounds/passages/gate_sections.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// Looks for a proof that every way of the middle of the chain from start to goal leads through a
/// gate where no chain can have its middle.
///
/// It takes the shortest way in the plane, examines sections of the gates on it (see EmptyRegion),
/// makes a wall of one that is empty, and goes on with the shortest way that is left. Nothing is
/// proven once there is a way through gates none of which turned out to be closed.
///
/// The proof holds for all primitive steps that the validator accepts: a section that counts as
/// empty is so together with half a step on all sides, and the middle of the chain, if it moved
/// straight from state to state, would on the section be that near to one of two states.
class GateCheck {
  public:
    /// Precondition: a chain of 3 to most_asvs_in_cells ASVs that keep their orientation, bounds,
    /// and valid ends.
    explicit GateCheck(const TurnedLeft& turned);

    /// Looks at so many cells of chains at most; the number is reduced by those that it has looked
    /// at.
    void work(std::size_t& cells);

    /// Is there nothing left to look for?
    bool finished() const { return finished_; }
    bool proven() const { return proven_; }

    /// Where the middle of the chain cannot be, as far as is known, in the problem that is turned
    /// left.
    std::vector<Box> closed() const;

    /// Names the gates that are in the way. Precondition: proven.
    Feasibility conclusion() const;

  private:
    struct ClosedPart {
        Box closed;
        std::string place;  ///< "between obstacles 1 and 2"
        bool slit = false;  ///< there because of the tolerance: the two touch, or nearly so
    };

    bool separate(const std::vector<ClosedPart>& parts) const;
    void look_for_sections(std::size_t& cells);
    void examine_next(std::size_t& cells);
    bool is_slit(const GateSection& section) const;
    std::string place_of_gate(const GateSection& section) const;
    std::string name_of_border(std::size_t number) const;
    std::vector<ClosedPart> decisive_parts() const;

    TurnedLeft turned_;
    std::vector<Box> walls_;  ///< the obstacles as the middle of the chain meets them
    std::vector<std::size_t> obstacle_of_wall_;
    std::vector<ClosedPart> closed_;
    std::vector<GateSection> waiting_;  ///< the last is next
    std::vector<GateSection> examined_;
    std::optional<EmptyRegion> region_;  ///< around the section that is next
    bool proven_ = false;
    bool finished_ = false;
};

}  // namespace asv::core
