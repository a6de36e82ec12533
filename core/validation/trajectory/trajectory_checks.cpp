#include "core/validation/trajectory/trajectory_checks.hpp"

#include <algorithm>

#include "core/validation/path_checks.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core::validation {

namespace {

using geometry::Point;

/// The velocity of a vehicle between the sample before and this one; 0 before the first one and
/// behind the last one.
Point velocity(const Trajectory& trajectory, std::size_t vehicle, std::size_t sample) {
    if (sample == 0 || sample == trajectory.size()) return {};
    const double time = trajectory.times[sample] - trajectory.times[sample - 1];
    const Point &from = trajectory.states.state(sample - 1)[vehicle],
                &to = trajectory.states.state(sample)[vehicle];
    return {(to.x - from.x) / time, (to.y - from.y) / time};
}

/// A limit, and the value that shall not exceed it.
Finding within(double limit, double value, std::size_t vehicle) {
    return at_asv(value <= limit * (1 + limit_share), vehicle, limit - value);
}

}  // namespace

void add_times(const Trajectory& trajectory, Tally& times) {
    for (std::size_t k = 1; k < trajectory.size(); ++k) {
        Finding finding;
        finding.offender.room = trajectory.times[k] - trajectory.times[k - 1];
        finding.ok = finding.offender.room > 0;
        times.add(finding, k);
    }
}

void add_path(const Trajectory& trajectory, const Path& path, double tolerance, Tally& same_path) {
    const std::size_t last_sample = trajectory.size() - 1, last_state = path.size() - 1;
    const auto pair = [&](std::size_t sample, std::size_t state) {
        return check_distances(trajectory.states.state(sample), path.state(state), tolerance);
    };
    const auto after = [&](std::size_t state) { return std::min(state + 1, last_state); };
    same_path.add(pair(0, 0), 0);
    // The state that belongs to the sample before.
    std::size_t state = 0;
    for (std::size_t sample = 1; sample <= last_sample && same_path.worst().ok; ++sample) {
        Finding found = pair(sample, after(state));
        while (!found.ok && state < last_state && pair(sample - 1, after(state)).ok)
            found = pair(sample, after(++state));
        if (found.ok) {
            state = after(state);
        } else if (const Finding stays = pair(sample, state); stays.ok) {
            found = stays;
        }
        same_path.add(found, sample);
    }
    // What is left of the path has to be where the trajectory ends.
    while (state < last_state && same_path.worst().ok)
        same_path.add(pair(last_sample, ++state), last_sample);
}

void add_speeds(const Trajectory& trajectory, const MotionLimits& limits, Tally& speed) {
    for (std::size_t k = 1; k < trajectory.size(); ++k) {
        Finding worst;
        for (std::size_t i = 0; i < trajectory.states.asv_count(); ++i) {
            const Point v = velocity(trajectory, i, k);
            keep_worse(worst, within(limits.speed_of(i), elementary::hypot(v.x, v.y), i));
        }
        speed.add(worst, k);
    }
}

void add_accelerations(const Trajectory& trajectory, const MotionLimits& limits,
                       Tally& acceleration) {
    const std::size_t last = trajectory.size() - 1;
    if (last == 0) return;
    for (std::size_t k = 0; k <= last; ++k) {
        const double since = trajectory.times[k] - trajectory.times[k == 0 ? 0 : k - 1];
        const double until = trajectory.times[k == last ? last : k + 1] - trajectory.times[k];
        const double time = (since + until) / 2;
        Finding worst;
        for (std::size_t i = 0; i < trajectory.states.asv_count(); ++i) {
            const Point before = velocity(trajectory, i, k), after = velocity(trajectory, i, k + 1);
            const double change = elementary::hypot(after.x - before.x, after.y - before.y);
            keep_worse(worst, within(limits.acceleration_of(i), change / time, i));
        }
        acceleration.add(worst, k);
    }
}

}  // namespace asv::core::validation
