#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::core {

/// The plane within bounds, cut into rectangles along the sides of boxes, so that each box is a
/// union of some, and further until none is longer than told. Places are numbered.
class PlaceGrid {
  public:
    PlaceGrid(const geometry::Box& bounds, std::span<const geometry::Box> boxes, double longest);

    std::size_t size() const { return columns() * rows(); }
    geometry::Box box(std::size_t place) const;

    /// A place that holds the point. Precondition: the point is within the bounds.
    std::size_t place_at(const geometry::Point& point) const;

    /// Those that share a side with it, at most four.
    std::vector<std::size_t> neighbours(std::size_t place) const;

  private:
    std::size_t columns() const { return xs_.size() - 1; }
    std::size_t rows() const { return ys_.size() - 1; }

    std::vector<double> xs_, ys_;  ///< where it is cut, in ascending order, the bounds included
};

}  // namespace asv::core
