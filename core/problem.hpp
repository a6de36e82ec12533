#pragma once

#include <cstddef>
#include <vector>

#include "asv/core/requirements.hpp"
#include "asv/geometry/primitives.hpp"

namespace asv::core {

using geometry::Box;
using geometry::Point;

/// Where the ASVs stand, in chain order, and where they shall go, among closed rectangles.
/// Invariant kept by the readers: start.size() == goal.size() >= 1, all numbers finite,
/// obstacles not empty.
struct Problem {
    std::vector<Point> start;
    std::vector<Point> goal;
    std::vector<Box> obstacles;
    Requirements requirements;

    std::size_t asv_count() const { return start.size(); }
};

}  // namespace asv::core
