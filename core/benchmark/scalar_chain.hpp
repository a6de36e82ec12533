#pragma once

#include <span>
#include <vector>

#include "core/chain/batch/chain_batch.hpp"
#include "geometry/primitives.hpp"

/// A full state check as a careful programmer writes it without SIMD: the reference that the
/// kernels are tested and measured against. It shares the exact segment test with the library, no
/// more.

namespace asv::core::reference {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

/// Positions of the points of one chain; row: x, y, heading of every link. anchor_lever is ignored.
void positions(std::span<const double> row, double link, std::span<Point> points);

/// Do these points, with these headings, keep every limit but the boxes?
bool shape_valid(std::span<const double> row, std::span<const Point> points,
                 const batch::ChainLimits& limits);

/// Does any link meet any box? Bounding boxes first, as most pairs are far apart.
bool meets_any(std::span<const Point> points, std::span<const Box> boxes);

/// The whole check; scratch has one place for every point.
bool valid(std::span<const double> row, const batch::ChainLimits& limits,
           std::span<const Box> boxes, std::span<Point> scratch);

}  // namespace asv::core::reference
