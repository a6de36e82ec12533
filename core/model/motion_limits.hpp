#pragma once

#include <cstddef>
#include <vector>

namespace asv::core {

/// Every speed and acceleration limit lies between these.
inline constexpr double least_motion_limit = 1e-12, greatest_motion_limit = 1e12;

/// How fast the vehicles may move, and how fast their velocity may change, whatever its direction.
/// The vehicles of an arm are the points of its states: base, joints, tip.
/// Each list has one number for all vehicles or one for each; it is empty where nothing is known.
struct MotionLimits {
    std::vector<double> speed = {};         ///< workspace units per second
    std::vector<double> acceleration = {};  ///< workspace units per second squared

    double speed_of(std::size_t vehicle) const {
        return speed.size() == 1 ? speed.front() : speed[vehicle];
    }
    double acceleration_of(std::size_t vehicle) const {
        return acceleration.size() == 1 ? acceleration.front() : acceleration[vehicle];
    }
    bool known() const { return !speed.empty() && !acceleration.empty(); }

    friend bool operator==(const MotionLimits&, const MotionLimits&) = default;
};

/// Throws std::invalid_argument, which names the list, unless each has one number or one for each
/// vehicle, all between least_motion_limit and greatest_motion_limit.
void require_usable(const MotionLimits& limits, std::size_t vehicles);

}  // namespace asv::core
