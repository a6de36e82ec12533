#include "geometry/free_plane/cell_graph.hpp"

#include <algorithm>
#include <bit>

namespace asv::geometry::detail {

namespace {

constexpr std::array all_sides{Side::east, Side::north, Side::west, Side::south};

Portal make_portal(const Box& from, const Box& to, CellTree::Id cell, Side side) {
    const Point low{std::max(from.low.x, to.low.x), std::max(from.low.y, to.low.y)};
    const Point high{std::min(from.high.x, to.high.x), std::min(from.high.y, to.high.y)};
    switch (side) {
        case Side::east:
            return {cell, side, {high.x, low.y}, high};
        case Side::north:
            return {cell, side, high, {low.x, high.y}};
        case Side::west:
            return {cell, side, {low.x, high.y}, low};
        default:
            return {cell, side, low, {high.x, low.y}};
    }
}

/// Is the point an end of one of these portals?
bool is_end(const Point& point, std::span<const Portal> portals, Side side) {
    return std::any_of(portals.begin(), portals.end(), [&](const Portal& portal) {
        return portal.side == side && (portal.right == point || portal.left == point);
    });
}

}  // namespace

std::size_t CellGraph::HashPoint::operator()(const Point& point) const {
    // Multiplicative mixing; adding zero makes the two zeros, which compare equal, hash equally.
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
    std::uint64_t hash = std::bit_cast<std::uint64_t>(point.x + 0.0) * odd;
    hash = (std::rotl(hash, 29) ^ std::bit_cast<std::uint64_t>(point.y + 0.0)) * odd;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
}

std::vector<CellTree::Id> CellGraph::cells_at(const Point& point) {
    std::vector<CellTree::Id> cells;
    for (const int to_x : {-1, 1}) {
        for (const int to_y : {-1, 1}) {
            const CellTree::Id cell = tree_.find(point, to_x, to_y);
            if (cell == CellTree::none) continue;
            if (std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
        }
    }
    return cells;
}

std::span<const Portal> CellGraph::portals(CellTree::Id cell) {
    const Range range = look_at(cell).portals;
    return std::span(portals_).subspan(range.first, range.count);
}

std::span<const Corner> CellGraph::corners(CellTree::Id cell) {
    const Range range = look_at(cell).corners;
    return std::span(corners_).subspan(range.first, range.count);
}

const CellGraph::Cell& CellGraph::look_at(CellTree::Id id) {
    if (id >= cells_.size()) cells_.resize(std::max<std::size_t>(tree_.size(), id + 1));
    if (cells_[id].known) return cells_[id];
    Cell cell;
    cell.known = true;
    cell.portals.first = static_cast<std::uint32_t>(portals_.size());
    cell.corners.first = static_cast<std::uint32_t>(corners_.size());
    for (const Side side : all_sides) {
        const std::size_t first = portals_.size();
        neighbours_.clear();
        tree_.append_neighbours(id, side, neighbours_);
        for (const CellTree::Id other : neighbours_) {
            portals_.push_back(make_portal(tree_.box(id), tree_.box(other), other, side));
        }
        add_side_corners(id, std::span(portals_).subspan(first));
    }
    add_own_corners(id, std::span(portals_).subspan(cell.portals.first));
    cell.portals.count = static_cast<std::uint32_t>(portals_.size()) - cell.portals.first;
    cell.corners.count = static_cast<std::uint32_t>(corners_.size()) - cell.corners.first;
    return cells_[id] = cell;
}

void CellGraph::add_side_corners(CellTree::Id id, std::span<const Portal> side) {
    const Box& box = tree_.box(id);
    for (const Portal& portal : side) {
        const bool vertical = portal.side == Side::east || portal.side == Side::west;
        for (const bool at_left : {false, true}) {
            const Point& end = at_left ? portal.left : portal.right;
            const Point& other = at_left ? portal.right : portal.left;
            const bool own = vertical ? end.y == box.low.y || end.y == box.high.y
                                      : end.x == box.low.x || end.x == box.high.x;
            if (own) continue;
            // Beside the portal the wall begins, unless the next portal does.
            const bool shared = std::any_of(side.begin(), side.end(), [&](const Portal& next) {
                return at_left ? next.right == end : next.left == end;
            });
            if (shared) continue;
            if (vertical) {
                add_corner(end, portal.side == Side::east ? 1 : -1, end.y > other.y ? 1 : -1);
            } else {
                add_corner(end, end.x > other.x ? 1 : -1, portal.side == Side::north ? 1 : -1);
            }
        }
    }
}

void CellGraph::add_own_corners(CellTree::Id id, std::span<const Portal> portals) {
    const Box box = tree_.box(id);
    for (const int x : {-1, 1}) {
        for (const int y : {-1, 1}) {
            const Point point{x > 0 ? box.high.x : box.low.x, y > 0 ? box.high.y : box.low.y};
            const bool beside_x = is_end(point, portals, x > 0 ? Side::east : Side::west);
            const bool beside_y = is_end(point, portals, y > 0 ? Side::north : Side::south);
            if (!beside_x && !beside_y) continue;
            const bool across = tree_.find(point, x, y) != CellTree::none;
            if (beside_x && beside_y && !across) add_corner(point, x, y);
            if (beside_x && !beside_y && across) add_corner(point, -x, y);
            if (!beside_x && beside_y && across) add_corner(point, x, -y);
        }
    }
}

void CellGraph::add_corner(const Point& point, int obstacle_x, int obstacle_y) {
    const auto next = static_cast<std::uint32_t>(corner_ids_.size());
    const std::uint32_t id = corner_ids_.try_emplace(point, next).first->second;
    corners_.push_back({point, id, obstacle_x, obstacle_y});
}

}  // namespace asv::geometry::detail
