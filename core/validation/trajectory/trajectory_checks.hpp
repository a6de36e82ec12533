#pragma once

#include "core/model/motion_limits.hpp"
#include "core/model/path.hpp"
#include "core/model/trajectory.hpp"
#include "core/validation/finding.hpp"

/// The requirements on a trajectory, sample by sample, by code of the validator's own. Precondition
/// of all: finite positions and times, increasing ones but for add_times(); as many vehicles in the
/// trajectory as in the path and the limits; at least one sample and one state.

namespace asv::core::validation {

/// Limits are kept when they are exceeded by no more than this share of theirs, so that a file may
/// round its numbers.
inline constexpr double limit_share = 1e-6;

/// Each time is greater than the one before. Room: seconds.
void add_times(const Trajectory& trajectory, Tally& times);

/// The samples are the states of the path, in their order, each vehicle within the tolerance of its
/// place; a state that is within the tolerance of the same sample as its neighbour needs no sample
/// of its own. Ends at the first sample that leaves the path. Room: length.
void add_path(const Trajectory& trajectory, const Path& path, double tolerance, Tally& same_path);

/// Every vehicle keeps its speed limit between each sample and the one before. Room: speed.
void add_speeds(const Trajectory& trajectory, const MotionLimits& limits, Tally& speed);

/// Every vehicle keeps its acceleration limit at each sample, at rest before the first one and
/// after the last one. Room: acceleration.
void add_accelerations(const Trajectory& trajectory, const MotionLimits& limits,
                       Tally& acceleration);

}  // namespace asv::core::validation
