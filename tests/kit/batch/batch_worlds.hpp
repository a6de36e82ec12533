#pragma once

#include <cstddef>
#include <vector>

#include "core/chain/batch/chain_batch.hpp"
#include "geometry/primitives.hpp"
#include "tests/kit/random.hpp"

/// Worlds and chains to measure in and to test on; the same seed gives the same on every platform.

namespace asv::test {

/// Squares spread evenly over the unit square, so small that a chain of seven often avoids them:
/// side 0.1 for a few and 0.3 / count for many.
std::vector<geometry::Box> dust(std::size_t count, Random& random);

/// The occupied cells of a grid map of round blobs, count of them: solid ground with wide gaps.
std::vector<geometry::Box> grid_map(std::size_t count, Random& random);

/// The requirements of the assignment for chains of this many points, without tolerances.
core::batch::ChainLimits chain_limits(std::size_t points);

/// A configuration (x, y, headings) of a convex chain that is often valid: the total turn split
/// over the joints by exponential draws, placed anywhere.
std::vector<double> random_headings(std::size_t points, Random& random);

/// Valid configurations among the boxes, by rejection; fewer than count if they are too rare.
std::vector<std::vector<double>> valid_chains(std::size_t points, std::size_t count,
                                              const std::vector<geometry::Box>& boxes,
                                              Random& random);

}  // namespace asv::test
