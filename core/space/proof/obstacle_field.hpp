#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/boxes/box_index.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// The boxes near some region, as a structure of arrays.
struct NearBoxes {
    std::vector<double> low_x, low_y, high_x, high_y;

    std::size_t size() const { return low_x.size(); }
    void clear();
    void push_back(const geometry::Box& box);
    geometry::Box operator[](std::size_t i) const {
        return {{low_x[i], low_y[i]}, {high_x[i], high_y[i]}};
    }
};

/// The obstacles of a problem behind a broad phase. Immutable, shared by all threads.
class ObstacleField {
  public:
    explicit ObstacleField(std::span<const geometry::Box> boxes);

    /// So few boxes that looking at all of them is cheaper than finding the near ones.
    bool few() const { return boxes_.size() <= 12; }
    /// All boxes. Precondition: few().
    const NearBoxes& all() const { return all_; }
    /// Calls visit(index, box) for every box within the radius of the segment.
    template <class Visit>
    void visit_within(const geometry::Segment& segment, double radius, Visit&& visit) const {
        index_.visit_within(segment, radius, [&](std::size_t i) {
            visit(i, boxes_[i]);
            return false;
        });
    }
    /// How far boxes are apart, roughly, were they spread evenly: motions that are much longer
    /// are not worth looking at in one piece. Infinity where the boxes are few.
    double spacing() const { return spacing_; }

    /// True when the closed segment meets a box; exact.
    bool meets(const geometry::Segment& segment) const { return index_.meets(segment); }
    /// True when the point lies in a closed box.
    bool contains(const geometry::Point& point) const;

    std::span<const geometry::Box> boxes() const { return boxes_; }
    /// For the kernels that look at many configurations at once.
    const geometry::BoxIndex& index() const { return index_; }

  private:
    std::vector<geometry::Box> boxes_;
    geometry::BoxIndex index_;
    NearBoxes all_;
    double spacing_;
};

}  // namespace asv::core
