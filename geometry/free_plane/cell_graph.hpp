#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/free_plane/cell_tree.hpp"
#include "geometry/primitives.hpp"

namespace asv::geometry::detail {

/// The stretch of positive length that two cells share, seen by somebody who leaves through it.
struct Portal {
    CellTree::Id cell = CellTree::none;  ///< the cell on the other side
    Side side = Side::east;              ///< of the cell that is left
    Point right;                         ///< its end to the right
    Point left;                          ///< its end to the left
};

/// A point where a shortest path can bend: of its four quadrants exactly one is covered.
struct Corner {
    Point point;
    std::uint32_t id = 0;  ///< one number for each point
    int obstacle_x = 0;    ///< +1 or -1: in which quadrant the obstacle is
    int obstacle_y = 0;
};

/// The cells of a CellTree with their portals and corners, each worked out when first asked for.
class CellGraph {
  public:
    CellGraph(std::span<const Box> boxes, const Box& bounds) : tree_(boxes, bounds) {}

    const Box& box(CellTree::Id cell) const { return tree_.box(cell); }

    /// Every cell id is below this number; it grows as cells are looked at.
    std::size_t cell_limit() const { return tree_.size(); }

    /// The cells whose closed rectangle holds the point; empty when it is covered or outside.
    std::vector<CellTree::Id> cells_at(const Point& point);

    /// The ways out of the cell. Valid until the next call of portals or corners.
    std::span<const Portal> portals(CellTree::Id cell);

    /// The corners on the border of the cell. Valid until the next call of portals or corners.
    std::span<const Corner> corners(CellTree::Id cell);

    /// Every corner id is below this number; it grows as cells are looked at.
    std::size_t corner_limit() const { return corner_ids_.size(); }

  private:
    struct Range {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    struct Cell {
        Range portals;
        Range corners;
        bool known = false;
    };
    struct HashPoint {
        std::size_t operator()(const Point& point) const;
    };

    const Cell& look_at(CellTree::Id id);
    void add_side_corners(CellTree::Id id, std::span<const Portal> side);
    void add_own_corners(CellTree::Id id, std::span<const Portal> portals);
    void add_corner(const Point& point, int obstacle_x, int obstacle_y);

    CellTree tree_;
    std::vector<Cell> cells_;
    std::vector<Portal> portals_;
    std::vector<Corner>
        corners_;  ///< a copy for each cell, so that a look at a cell is at one place
    std::unordered_map<Point, std::uint32_t, HashPoint> corner_ids_;
    std::vector<CellTree::Id> neighbours_;
};

}  // namespace asv::geometry::detail
