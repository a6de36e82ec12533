#include "core/validation/trajectory/validate_trajectory.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/validation/state_checks.hpp"
#include "core/validation/trajectory/trajectory_checks.hpp"

namespace asv::core {

namespace {

using validation::Finding;
using validation::Tally;

void require_same_vehicles(const Path& path, const Trajectory& trajectory,
                           const MotionLimits& limits, double tolerance) {
    if (path.empty() || trajectory.times.empty())
        throw std::invalid_argument("validate_trajectory: the path or the trajectory is empty");
    if (trajectory.states.size() != trajectory.times.size() ||
        trajectory.states.asv_count() != path.asv_count())
        throw std::invalid_argument(
            "validate_trajectory: path and trajectory differ in their number of vehicles");
    if (!(tolerance >= 0 && std::isfinite(tolerance)))
        throw std::invalid_argument("validate_trajectory: the tolerance is negative or not finite");
    require_usable(limits, path.asv_count());
}

/// The first sample that is no place at a time, as a violation.
bool has_only_finite(const Trajectory& trajectory, Tally& times) {
    for (std::size_t k = 0; k < trajectory.size(); ++k) {
        std::optional<Finding> found = validation::find_not_finite(trajectory.states.state(k));
        if (!found && !std::isfinite(trajectory.times[k])) {
            found.emplace();
            found->ok = false;
            found->offender.room = trajectory.times[k];
        }
        if (!found) continue;
        times.add(*found, k);
        return false;
    }
    return true;
}

}  // namespace

ValidationReport validate_trajectory(BodyKind body, const Path& path, const Trajectory& trajectory,
                                     const MotionLimits& limits, const ValidationOptions& options) {
    require_same_vehicles(path, trajectory, limits, options.tolerance);
    const auto tally = [&](Check check) { return Tally(check, options.list_offenders, body); };
    Tally times = tally(Check::times), same_path = tally(Check::same_path);
    Tally speed = tally(Check::speed), acceleration = tally(Check::acceleration);
    if (has_only_finite(trajectory, times)) {
        validation::add_times(trajectory, times);
        validation::add_path(trajectory, path, options.tolerance, same_path);
        if (times.worst().ok) {
            validation::add_speeds(trajectory, limits, speed);
            validation::add_accelerations(trajectory, limits, acceleration);
        }
    }
    ValidationReport report;
    for (Tally* one : {&times, &same_path, &speed, &acceleration})
        report.checks.push_back(std::move(*one).result());
    return report;
}

}  // namespace asv::core
