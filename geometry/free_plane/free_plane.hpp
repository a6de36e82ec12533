#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::geometry {

/// What boxes leave free of a rectangle, for a point that moves in it: which places are connected,
/// and how far it is from one to the other.
///
/// The point may come arbitrarily close to a box and to the border, but not onto them: boxes that
/// touch, if only at a corner, leave no way between them, nor do a box and the border that it
/// touches. A length is the limit that such paths approach, so that paths along a wall count.
/// Boxes without interior are ignored. The parts of boxes outside the bounds do not matter.
///
/// The free part is cut into cells only where a question leads; the answers are kept for the next
/// question, so that a FreePlane must not be used by two threads at once.
class FreePlane {
  public:
    /// O(boxes). Precondition: finite coordinates, fewer than 2^30 boxes, bounds has an interior.
    FreePlane(std::span<const Box> boxes, const Box& bounds);
    FreePlane(FreePlane&&) noexcept;
    FreePlane& operator=(FreePlane&&) noexcept;
    ~FreePlane();

    /// Is the point free or on the border of the free part? A point inside the union of the boxes
    /// or outside the bounds is not.
    bool is_free(const Point& point);

    /// Are both points free and in the same component? A point where components touch is in each.
    bool connected(const Point& from, const Point& to);

    /// The length of the shortest path; 0 from a free point to itself, infinity where the points
    /// are not connected. The relative error is below 1e-15 and 2e-16 more for each bend.
    double shortest_path(const Point& from, const Point& to);

    /// The same, given up in a dense crowd of boxes: a length that no path is shorter than. It is
    /// that of the shortest path unless finding it takes entering more than `effort` of the cells
    /// (each as often as it is entered, a million in about half a second).
    double shortest_path_at_least(const Point& from, const Point& to, std::size_t effort);

    /// The shortest path itself: from, where it bends, to. Empty where the points are not connected
    /// or finding it takes more than that effort.
    std::vector<Point> shortest_path_points(const Point& from, const Point& to, std::size_t effort);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace asv::geometry
