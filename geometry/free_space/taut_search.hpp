#pragma once

#include "asv/geometry/free_space/cell_graph.hpp"
#include "asv/geometry/primitives.hpp"

namespace asv::geometry::detail {

/// The length of the shortest path between two points through the cells of the graph; infinity
/// where there is none. It bends at corners only, and there only around the obstacle, so that it
/// is found by A* over the corners. What a corner sees is explored as cones through the portals,
/// those first that can lead to the shortest total (after Cui, Harabor, Grastien, "Compromise-free
/// pathfinding on a navigation mesh", IJCAI 2017). What is seen is decided exactly; lengths are
/// rounded, with a relative error below 1e-13.
/// Precondition: start and goal are in the same component, or time does not matter.
double taut_length(CellGraph& graph, const Point& start, const Point& goal);

}  // namespace asv::geometry::detail
