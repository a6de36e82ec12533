#include "core/trajectory/time_optimal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "core/trajectory/path_pace.hpp"

namespace asv::core {

namespace {

using geometry::Point;
using State = std::span<const Point>;

double square(double value) {
    return value * value;
}

double squared_distance(const Point& a, const Point& b) {
    return square(b.x - a.x) + square(b.y - a.y);
}

/// The square of how far the vehicle that moves farthest gets.
double squared_move(State from, State to) {
    double most = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        most = std::max(most, squared_distance(from[i], to[i]));
    return most;
}

/// The states that do not repeat the one before; the first and, but where all are the same, the
/// last are as they were.
Path without_repetitions(const Path& path) {
    double longest = 0;
    for (std::size_t k = 1; k < path.size(); ++k)
        longest = std::max(longest, squared_move(path.state(k - 1), path.state(k)));
    const auto same = [&](std::size_t a, std::size_t b) {
        return squared_move(path.state(a), path.state(b)) <= square(same_state_share) * longest;
    };
    std::vector<std::size_t> kept{0};
    for (std::size_t k = 1; k < path.size(); ++k)
        if (!same(kept.back(), k)) kept.push_back(k);
    const std::size_t last = path.size() - 1;
    if (kept.back() != last) {
        while (kept.size() > 1 && same(kept.back(), last)) kept.pop_back();
        if (!same(kept.back(), last)) kept.push_back(last);
    }
    Path states(path.asv_count());
    states.reserve(kept.size());
    for (const std::size_t k : kept) states.push_back(path.state(k));
    return states;
}

/// Of each vehicle the inverse square of a limit.
std::vector<double> inverse_squares(const std::vector<double>& limits, std::size_t vehicles) {
    std::vector<double> inverse(vehicles, 1 / square(limits.front()));
    if (limits.size() > 1)
        for (std::size_t i = 0; i < vehicles; ++i) inverse[i] = 1 / square(limits[i]);
    return inverse;
}

/// scales: the inverse acceleration limits of the vehicles; of_speed: inverse squares.
void append_step(State from, State to, const std::vector<double>& scales,
                 const std::vector<double>& of_speed, trajectory::ScaledSteps& steps) {
    const std::size_t first = steps.directions.size();
    double square_sum = 0;
    double square_time = 0;  // that the speed limits leave at the least
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double scale = scales[i];
        const double x = to[i].x - from[i].x, y = to[i].y - from[i].y;
        steps.directions.push_back(x * scale);
        steps.directions.push_back(y * scale);
        square_sum += (x * x + y * y) * square(scale);
        square_time = std::max(square_time, (x * x + y * y) * of_speed[i]);
    }
    const double length = std::sqrt(square_sum), per_length = 1 / length;
    for (std::size_t i = first; i < steps.directions.size(); ++i) steps.directions[i] *= per_length;
    steps.lengths.push_back(length);
    steps.fastest.push_back(length / std::sqrt(square_time));
}

trajectory::ScaledSteps scaled_steps(const Path& states, const MotionLimits& limits) {
    trajectory::ScaledSteps steps;
    steps.vehicles = states.asv_count();
    const std::size_t count = states.size() - 1;
    steps.lengths.reserve(count);
    steps.fastest.reserve(count);
    steps.directions.reserve(count * 2 * steps.vehicles);
    const std::vector<double> of_speed = inverse_squares(limits.speed, steps.vehicles);
    std::vector<double> scales;
    for (std::size_t i = 0; i < steps.vehicles; ++i)
        scales.push_back(1 / limits.acceleration_of(i));
    for (std::size_t k = 1; k < states.size(); ++k)
        append_step(states.state(k - 1), states.state(k), scales, of_speed, steps);
    return steps;
}

/// How many times as long the trajectory has to take for every limit to hold, of its times and
/// positions as they are rounded; at most 1 where all hold.
double needed_slowing(const Trajectory& trajectory, const MotionLimits& limits) {
    const Path& states = trajectory.states;
    const std::size_t n = states.asv_count();
    const std::vector<double> of_speed = inverse_squares(limits.speed, n),
                              of_acceleration = inverse_squares(limits.acceleration, n);
    double by_speed = 0, by_acceleration = 0;  // squared
    std::vector<Point> velocities(n);
    double time_before = 0;
    for (std::size_t k = 1; k <= states.size(); ++k) {
        const bool moves = k < states.size();
        const State from = states.state(k - 1), to = moves ? states.state(k) : from;
        const double time = moves ? trajectory.times[k] - trajectory.times[k - 1] : 0;
        const double per_time = moves ? 1 / time : 0;
        double of_change = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Point next = {(to[i].x - from[i].x) * per_time, (to[i].y - from[i].y) * per_time};
            by_speed = std::max(by_speed, squared_distance({}, next) * of_speed[i]);
            of_change =
                std::max(of_change, squared_distance(velocities[i], next) * of_acceleration[i]);
            velocities[i] = next;
        }
        by_acceleration = std::max(by_acceleration, of_change / square((time_before + time) / 2));
        time_before = time;
    }
    return std::max(std::sqrt(by_speed), std::sqrt(std::sqrt(by_acceleration)));
}

}  // namespace

Trajectory time_optimal(const Path& path, const MotionLimits& limits) {
    if (path.empty()) throw std::invalid_argument("time_optimal: the path is empty");
    require_usable(limits, path.asv_count());
    Trajectory trajectory{without_repetitions(path), {0}};
    if (trajectory.states.size() == 1) return trajectory;
    const trajectory::ScaledSteps steps = scaled_steps(trajectory.states, limits);
    const std::vector<double> pace = trajectory::paces(steps);
    trajectory.times.resize(trajectory.states.size());
    // At times c as long, velocities are 1/c and accelerations 1/c^2 of what they were. That mends
    // what the rounding of times leaves.
    double slowing = 1, margin = 1e-9;
    while (true) {
        slowing *= 1 + margin;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const double now = trajectory.times[k];
            const double soonest = std::nextafter(now, std::numeric_limits<double>::infinity());
            trajectory.times[k + 1] = std::max(soonest, now + slowing * steps.lengths[k] / pace[k]);
        }
        const double needed = needed_slowing(trajectory, limits);
        if (needed <= 1) return trajectory;
        slowing *= needed;
        margin *= 2;
    }
}

}  // namespace asv::core
