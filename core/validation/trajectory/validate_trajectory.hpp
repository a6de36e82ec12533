#pragma once

#include "core/model/motion_limits.hpp"
#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/model/trajectory.hpp"
#include "core/validation/report.hpp"
#include "core/validation/validation_options.hpp"

namespace asv::core {

/// Checks that a trajectory passes a path, without any code of what has made it: times (they
/// increase), same path (its samples are the states of the path in their order, each vehicle within
/// the tolerance; where states repeat, one of them suffices), speed and acceleration (no vehicle
/// exceeds its limits, in the meaning of core/model/trajectory.hpp, by more than a millionth).
///
/// Where a position or a time is not finite, or times do not increase, the later checks have
/// nothing to look at. body: whose points the vehicles are.
/// Throws std::invalid_argument when path, trajectory and limits differ in their number of
/// vehicles, when there is no state or no sample, or when the tolerance is negative or not finite.
/// O((states + samples) * vehicles).
ValidationReport validate_trajectory(BodyKind body, const Path& path, const Trajectory& trajectory,
                                     const MotionLimits& limits,
                                     const ValidationOptions& options = {});

}  // namespace asv::core
