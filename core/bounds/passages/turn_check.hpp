#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/bounds/passages/cells/empty_region.hpp"
#include "core/bounds/passages/place_grid.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// Looks for a proof that the chain cannot turn on its way as it would have to, as in two narrow
/// bends to different sides.
///
/// The plane of the middle of the chain is cut into places, and the headings of the broom behind it
/// into equal parts. A place with a part is a node; nodes are neighbours where the places or the
/// parts are. One is closed if no state has its middle in the place and its heading in the part
/// (see EmptyRegion). On a way from the start's node to the goal's, with as few nodes as possible
/// that are not known to be open, those are examined; then there is another way. Either none is
/// left, which is the proof, or one of open nodes.
///
/// It holds for all primitive steps that the validator accepts: a node counts as closed if it is so
/// together with half a step on all sides and half of what the heading may change in a step. While
/// middle and heading change evenly from state to state, they are always that near to one of two
/// states.
class TurnCheck {
  public:
    /// closed: where the middle of the chain cannot be.
    /// Precondition: the problem is turned_left(), of 3 to most_asvs_in_cells ASVs that keep their
    /// orientation, and has bounds.
    TurnCheck(const Problem& problem, std::span<const Box> closed);

    /// Looks at so many cells at most; the number is reduced by those that it has looked at.
    void work(std::size_t& cells);

    /// Is there nothing left to look for?
    bool finished() const { return finished_; }
    bool proven() const { return proven_; }

    /// Where the chain gets from the start with some headings, and from the goal with others.
    /// Precondition: proven.
    std::vector<Box> places_to_turn() const;

  private:
    enum class Verdict : std::uint8_t { unknown, open, closed };

    static std::vector<Box> walls_of(const Problem& problem, std::span<const Box> closed);
    std::size_t node_of(const std::vector<Point>& state) const;
    std::vector<std::size_t> neighbours(std::size_t node) const;
    std::vector<std::size_t> way() const;
    std::vector<bool> places_reached_from(std::size_t node) const;
    EmptyRegion region_of(std::size_t node) const;
    void examine_next(std::size_t& cells);

    Problem problem_;
    std::vector<Box> walls_;
    PlaceGrid grid_;
    std::vector<Verdict> verdicts_;  ///< of the nodes: all parts of the first place, then the next
    std::size_t start_ = 0, goal_ = 0;
    std::vector<std::size_t> waiting_;   ///< nodes on a way; the last is next
    std::optional<EmptyRegion> region_;  ///< that of the next node
    bool proven_ = false;
    bool finished_ = false;
};

}  // namespace asv::core
