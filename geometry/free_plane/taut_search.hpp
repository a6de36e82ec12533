#pragma once

#include <cstddef>
#include <vector>

#include "geometry/free_plane/cell_graph.hpp"
#include "geometry/primitives.hpp"

namespace asv::geometry::detail {

/// The length of the shortest path between two points through the cells of the graph; infinity
/// where there is none. When finding it takes entering more than `effort` cells (each as often as
/// it is entered), a length that every path has at least.
///
/// The shortest path bends at corners only, and there only around the obstacle, so that it is found
/// by A* over the corners. What a corner sees is explored as cones through the portals, those first
/// that can lead to the shortest total (after Cui, Harabor, Grastien, "Compromise-free pathfinding
/// on a navigation mesh", IJCAI 2017). What is seen is decided exactly; lengths are rounded, with a
/// relative error below 1e-15 and 2e-16 more for each bend.
double taut_length(CellGraph& graph, const Point& start, const Point& goal, std::size_t effort);

/// That path: start, where it bends, goal; empty where there is none or finding it would take more
/// than the effort.
std::vector<Point> taut_path(CellGraph& graph, const Point& start, const Point& goal,
                             std::size_t effort);

}  // namespace asv::geometry::detail
