#include "core/bounds/lower_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Covers the rounding of lengths of up to a million bends.
constexpr double rounding = 1e-9;

/// The straight way between the joint angles of start and goal, less what the tolerance of both
/// ends allows: a link of length l whose ends are off by e turns by at most asin(2 e / l).
double straight_joint_way(const PlanarArm& arm, double tolerance) {
    double squared = 0, squared_slack = 0, slack_before = 0;
    for (std::size_t i = 0; i < arm.links.size(); ++i) {
        const double way = arm.goal[i] - arm.start[i];
        const double angle = arm.joints[i].wraps ? std::remainder(way, 2 * std::numbers::pi) : way;
        const double off = elementary::asin(std::min(1.0, 2 * tolerance / arm.links[i]));
        const double slack = arm.angles == AngleReference::x_axis ? off : off + slack_before;
        slack_before = off;
        squared += angle * angle;
        squared_slack += slack * slack;
    }
    return std::max(0.0, std::sqrt(squared) * (1 - rounding) - 2 * std::sqrt(squared_slack));
}

}  // namespace

CostLowerBound cost_lower_bound(const Problem& problem, Reading reading, std::size_t effort) {
    if (const PlanarArm* arm = problem.arm()) {
        const double distance = straight_joint_way(*arm, problem.requirements.tolerance);
        return {distance, {distance}};
    }
    geometry::FreePlane space = make_asv_plane(problem, reading);
    const std::size_t effort_of_each = effort / std::max<std::size_t>(1, problem.asv_count());
    CostLowerBound bound;
    for (std::size_t i = 0; i < problem.asv_count(); ++i) {
        const double apart =
            space.shortest_path_at_least(problem.start[i], problem.goal[i], effort_of_each);
        const double ends = 2 * problem.requirements.tolerance;
        const double length = std::max(0.0, apart * (1 - rounding) - ends);
        bound.lengths.push_back(length);
        bound.total += length;
    }
    return bound;
}

std::size_t steps_lower_bound(const Problem& problem, const CostLowerBound& bound) {
    if (problem.arm() || bound.lengths.empty()) return 0;
    const double longest = *std::max_element(bound.lengths.begin(), bound.lengths.end());
    if (!std::isfinite(longest)) return 0;
    return static_cast<std::size_t>(std::ceil(longest / problem.requirements.max_step));
}

}  // namespace asv::core
