#include <algorithm>
#include <optional>

#include "core/trajectory/time_optimal.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Of what the fastest vehicle moves; less is rest.
constexpr double rounding_share = 1e-9;

}  // namespace

std::vector<VehicleMotion> vehicle_motions(const Trajectory& trajectory) {
    const Path& states = trajectory.states;
    const std::size_t n = states.asv_count(), count = trajectory.size();
    std::vector<VehicleMotion> motions(count * n);
    std::vector<bool> has_moved(n, false);
    std::vector<double> moves(n);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t before = k == 0 ? 0 : k - 1, after = std::min(k + 1, count - 1);
        const double time = trajectory.times[after] - trajectory.times[before];
        const auto from = states.state(before), to = states.state(after);
        double farthest = 0;
        for (std::size_t i = 0; i < n; ++i) {
            moves[i] = elementary::hypot(to[i].x - from[i].x, to[i].y - from[i].y);
            farthest = std::max(farthest, moves[i]);
        }
        for (std::size_t i = 0; i < n; ++i) {
            VehicleMotion& motion = motions[k * n + i];
            if (k > 0) motion.heading = motions[(k - 1) * n + i].heading;
            if (!(moves[i] > rounding_share * farthest)) continue;
            motion.heading = elementary::atan2(to[i].y - from[i].y, to[i].x - from[i].x);
            if (k > 0 && k + 1 < count) motion.speed = moves[i] / time;
            if (!has_moved[i])
                for (std::size_t j = 0; j < k; ++j) motions[j * n + i].heading = motion.heading;
            has_moved[i] = true;
        }
    }
    return motions;
}

}  // namespace asv::core
