#pragma once

#include <cstddef>
#include <vector>

#include "core/model/body.hpp"
#include "core/model/motion_limits.hpp"
#include "core/model/requirements.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

using geometry::Box;
using geometry::Point;

/// Where the ASVs stand, in chain order, and where they shall go, among closed rectangles. For an
/// arm the points are its base, its joints and its tip.
/// Invariant kept by the readers: start.size() == goal.size() >= 1, all numbers finite,
/// obstacles not empty.
struct Problem {
    std::vector<Point> start;
    std::vector<Point> goal;
    std::vector<Box> obstacles;
    Requirements requirements;
    Body body = AsvChain{};
    /// For trajectories; no path depends on it.
    MotionLimits motion_limits = {};

    std::size_t asv_count() const { return start.size(); }
    BodyKind body_kind() const { return kind(body); }
    /// The arm; null for the other bodies.
    const PlanarArm* arm() const { return std::get_if<PlanarArm>(&body); }
};

}  // namespace asv::core
