#pragma once

#include <vector>

#include "geometry/primitives.hpp"

namespace asv::core {

/// Where a body is, as a start or a goal is told.
struct Placement {
    /// The ASVs of a chain in order, or the point; of an arm its base, joints and tip. Workspace
    /// units.
    std::vector<geometry::Point> points;
    std::vector<double> angles;  ///< of the joints of an arm, radians; empty for other bodies

    bool empty() const { return points.empty() && angles.empty(); }
};

}  // namespace asv::core
