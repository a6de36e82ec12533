#pragma once

#include <span>

#include "geometry/primitives.hpp"

namespace asv::test {

/// The length of the shortest path of a point among boxes by brute force: Dijkstra's algorithm on
/// all pairs of box corners that see each other. Boxes are first grown, and the bounds shrunk, by
/// `closing`, so that what touches is sealed; the result is off by a small multiple of that.
/// Infinity where there is no path. Shares no code with the library but the plain types.
double brute_force_shortest_path(std::span<const geometry::Box> boxes, const geometry::Box& bounds,
                                 const geometry::Point& from, const geometry::Point& to,
                                 double closing);

}  // namespace asv::test
