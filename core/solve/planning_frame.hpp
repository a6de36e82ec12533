#pragma once

#include <vector>

#include "core/model/path.hpp"
#include "core/model/placement.hpp"
#include "core/model/problem.hpp"
#include "core/solve/tree_picture.hpp"

namespace asv::core {

/// The problem in the coordinates in which it is planned, and the way back from there. On the way
/// in, the problem is
///
///  - reversed where that is asked for: it leads from the given goal to the given start;
///  - bounded: where the plane is endless, by the window in which a path is looked for;
///  - scaled, if it is a chain's, to units in which its brooms are about 0.05 long, since the
///    planner's lengths (margins, steps) are made for these;
///  - transposed, if it is a chain's that turns clockwise: x and y change places, which mirrors the
///    plane exactly, so that the planner knows counter-clockwise chains alone.
///
/// Units are a power of two long, so that no number changes but for its exponent: the way back
/// leads to the very coordinates that were given.
class PlanningFrame {
  public:
    /// Precondition: start and goal of the problem are valid, and a chain's of one orientation.
    explicit PlanningFrame(const Problem& given, bool reversed = false);

    /// The problem in planning coordinates, with finite bounds.
    const Problem& problem() const { return problem_; }

    bool reversed() const { return reversed_; }
    bool transposed() const { return transposed_; }
    /// Length of a unit of planning coordinates, in units of the given problem.
    double unit() const { return unit_; }

    /// From planning coordinates back to the given ones. An infinite cost stays infinite.
    double cost_back(double cost) const { return unit_ * cost; }
    Point point_back(const Point& point) const;
    /// A path of the given problem, or of one like it, in planning coordinates.
    Path path_in(const Path& given) const;
    /// Leads from the given start to the given goal.
    Path path_back(const Path& path) const;
    /// Of a path, from the given start to the given goal.
    std::vector<Placement> placements_back(std::vector<Placement> placements) const;
    /// The tree of the given start first.
    std::vector<TreePicture> trees_back(std::vector<TreePicture> trees) const;

  private:
    bool reversed_;
    double unit_;
    bool transposed_;
    Problem problem_;
};

}  // namespace asv::core
