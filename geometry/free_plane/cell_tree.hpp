#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::geometry::detail {

/// A side of a rectangle, named by where it lies.
enum class Side : std::uint8_t { east, north, west, south };

/// The part of a rectangle that no box covers, cut into rectangular cells: the free leaves of a
/// binary space partition whose cuts run along box sides. Nodes are refined when somebody first
/// asks for them, so that the work follows what is looked at, not all that there is.
class CellTree {
  public:
    using Id = std::uint32_t;
    static constexpr Id none = UINT32_MAX;

    /// Boxes without interior are ignored, as are the parts outside bounds. O(boxes).
    /// Precondition: finite coordinates, bounds has an interior.
    CellTree(std::span<const Box> boxes, const Box& bounds);

    /// The closed rectangle of the cell (or node) with this id.
    const Box& box(Id id) const { return nodes_[id].box; }

    /// Every id is below this number; it grows as nodes are refined.
    std::size_t size() const { return nodes_.size(); }

    /// The cell that holds the points right beside `point` in the quadrant (to_x, to_y), each of
    /// them +1 or -1; none where these points are covered or outside.
    Id find(const Point& point, int to_x, int to_y);

    /// Appends the cells that share with the cell's side a stretch of positive length, in
    /// increasing order along that side.
    void append_neighbours(Id cell, Side side, std::vector<Id>& neighbours);

  private:
    enum class State : std::uint8_t { unrefined, inner, free, blocked };

    struct Node {
        Box box;
        double cut = 0;  ///< inner nodes: the coordinate that parts the children
        Id child = 0;    ///< inner nodes: the child below the cut, the other follows it
        State state = State::unrefined;
        std::uint8_t axis = 0;                 ///< inner nodes: 0 when the cut is at an x, 1 at a y
        std::vector<std::uint32_t> obstacles;  ///< unrefined nodes: boxes that cover part of it
    };

    struct Cut {
        std::uint8_t axis = 0;
        double at = 0;
    };

    struct Strip;

    void add_node(const Box& box, std::span<const std::uint32_t> candidates);
    void refine(Id id);
    Cut choose_cut(const Node& node) const;
    bool central_side(const Node& node, std::uint8_t axis, double& at) const;
    Cut cheapest_cut(const Node& node) const;
    void collect(Id id, const Strip& strip, std::vector<Id>& found);

    std::vector<Box> boxes_;
    std::vector<Node> nodes_;
};

}  // namespace asv::geometry::detail
