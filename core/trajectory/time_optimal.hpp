#pragma once

#include <cstddef>
#include <vector>

#include "core/model/motion_limits.hpp"
#include "core/model/path.hpp"
#include "core/model/trajectory.hpp"

/// From a path, which says where the vehicles pass, to a trajectory, which says when.

namespace asv::core {

/// States of which no vehicle is farther from where it was than this share of the path's longest
/// move are the same state.
inline constexpr double same_state_share = 1e-6;

/// The path passed in as short a time as the limits of all vehicles allow, all at the same pace, so
/// that every state is passed as it is: from rest at the first state, at 0 seconds, to rest at the
/// last one. No limit is exceeded, in the meaning that core/model/trajectory.hpp gives to
/// velocities and accelerations, by any of the times and positions that are returned. States that
/// repeat the one before are left out; a path that stays where it is has a single sample.
///
/// Time scaling along the path: an upper bound of the pace at each step, then a pass backward for
/// braking and one forward for speeding up. (Bobrow, Dubowsky, Gibson: Time-optimal control of
/// robotic manipulators along specified paths, IJRR 4(3), 1985; as passes over a discretised path:
/// Pham, Pham: A new approach to time-optimal path parameterization based on reachability
/// analysis, IEEE T-RO 34(3), 2018.) The upper bound is that of the speeds, and where velocities
/// turn the greatest pace at which the turn can be passed evenly.
///
/// O(states * vehicles). Throws std::invalid_argument when the path is empty or the limits are not
/// usable for its vehicles. Precondition: all coordinates finite.
Trajectory time_optimal(const Path& path, const MotionLimits& limits);

/// How a vehicle moves while it passes a sample.
struct VehicleMotion {
    double heading = 0;  ///< radians from the +x axis, in [-pi, pi], counter-clockwise
    double speed = 0;    ///< workspace units per second
};

/// For each sample the motion of every vehicle, row by row: the mean of its velocities in the
/// intervals before and after the sample, weighted by how long they are, so that it points from the
/// sample before to the one after. A vehicle points where it goes. One that rests keeps its
/// heading, at the beginning that of its first motion; one that never moves has heading 0. Rounding
/// is rest: less than a billionth of what the fastest vehicle moves there. Speeds at the first and
/// the last sample are 0.
std::vector<VehicleMotion> vehicle_motions(const Trajectory& trajectory);

}  // namespace asv::core
