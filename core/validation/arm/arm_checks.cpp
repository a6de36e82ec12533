#include "core/validation/arm/arm_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/elementary/functions.hpp"

namespace asv::core::validation {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

}  // namespace

JointReader::JointReader(const PlanarArm& arm, std::vector<double> reference)
    : arm_(arm), angles_(std::move(reference)) {}

const std::vector<double>& JointReader::read(State state) {
    double heading_before = 0;
    for (std::size_t i = 0; i < angles_.size(); ++i) {
        const double heading =
            elementary::atan2(state[i + 1].y - state[i].y, state[i + 1].x - state[i].x);
        const bool absolute = arm_.angles == AngleReference::x_axis;
        const double angle = absolute ? heading : heading - heading_before;
        heading_before = heading;
        angles_[i] = angle - full_turn * std::round((angle - angles_[i]) / full_turn);
    }
    return angles_;
}

std::vector<double> middle_of_ranges(const PlanarArm& arm) {
    std::vector<double> middle;
    for (const JointRange& range : arm.joints) middle.push_back((range.low + range.high) / 2);
    return middle;
}

Finding check_link_lengths(State state, const PlanarArm& arm, const Requirements& requirements) {
    Finding worst;
    for (std::size_t i = 0; i < arm.links.size(); ++i)
        check_side_length(state, i, arm.links[i], requirements.tolerance, worst);
    return worst;
}

Finding check_base(State state, const geometry::Point& base, const Requirements& requirements) {
    const double off = distance(state[0], base);
    return at_asv(off <= requirements.tolerance, 0, requirements.tolerance - off);
}

Finding check_joint_limits(std::span<const double> angles, const PlanarArm& arm,
                           const Requirements& requirements) {
    Finding worst;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const JointRange& range = arm.joints[i];
        if (range.wraps) continue;
        const double room =
            std::min(angles[i] - range.low, range.high - angles[i]) + requirements.tolerance;
        keep_worse(worst, at_asv(room >= 0, i, room));
    }
    return worst;
}

Finding check_turns(std::span<const double> angles, std::span<const double> wanted,
                    const PlanarArm& arm) {
    Finding worst;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double turns = std::round((angles[i] - wanted[i]) / full_turn);
        if (arm.joints[i].wraps || turns == 0) continue;
        keep_worse(worst, at_asv(false, i, -std::abs(turns) * full_turn));
    }
    return worst;
}

double joint_distance(std::span<const double> from, std::span<const double> to) {
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) sum += (to[i] - from[i]) * (to[i] - from[i]);
    return std::sqrt(sum);
}

}  // namespace asv::core::validation
