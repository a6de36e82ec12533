#include "core/validation/state_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/elementary/functions.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core::validation {
namespace {

using geometry::Point;
using std::numbers::pi;

struct Turn {
    double angle = 0;
    std::size_t asv = 0;
};

/// Into (-pi, pi].
double normalised(double angle) {
    while (angle <= -pi) angle += 2 * pi;
    while (angle > pi) angle -= 2 * pi;
    return angle;
}

double heading(const Point& from, const Point& to) {
    return elementary::atan2(to.y - from.y, to.x - from.x);
}

}  // namespace

double distance(const Point& a, const Point& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    return std::sqrt(dx * dx + dy * dy);
}

std::optional<Finding> find_not_finite(State state) {
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (std::isfinite(state[i].x) && std::isfinite(state[i].y)) continue;
        return at_asv(false, i, -std::numeric_limits<double>::infinity());
    }
    return std::nullopt;
}

std::optional<Finding> find_not_finite(State from, State to) {
    const std::optional<Finding> found = find_not_finite(from);
    return found ? found : find_not_finite(to);
}

void check_side_length(State state, std::size_t i, double length, double tolerance,
                       Finding& worst) {
    const double found = distance(state[i], state[i + 1]);
    const double off = std::abs(found - length);
    const bool ok = off <= tolerance;
    const double room = tolerance - off;
    if (!worse(ok, room, worst)) return;
    worst = {};
    worst.ok = ok;
    worst.offender.broom = i;
    worst.offender.room = room;
    worst.offender.length = found;
    worst.offender.wanted_length = length;
}

Finding check_broom_lengths(State state, const Requirements& requirements) {
    Finding worst;
    for (std::size_t i = 0; i + 1 < state.size(); ++i)
        check_side_length(state, i, requirements.broom_length, requirements.tolerance, worst);
    return worst;
}

Finding check_convexity(State state, const Requirements& requirements) {
    const std::size_t n = state.size();
    const double e = requirements.tolerance;
    Turn left{-pi, 0};
    Turn right{pi, 0};
    Turn sharpest;
    double total = 0;
    double last = heading(state[0], state[1 % n]);
    for (std::size_t i = 1; i <= n; ++i) {
        const double next = heading(state[i % n], state[(i + 1) % n]);
        const Turn turn{normalised(next - last), i % n};
        last = next;
        total += std::abs(turn.angle);
        if (turn.angle > left.angle) left = turn;
        if (turn.angle < right.angle) right = turn;
        if (std::abs(turn.angle) > std::abs(sharpest.angle)) sharpest = turn;
    }
    // The smaller of the extremes is the one that turns against the others.
    const Turn against = left.angle < -right.angle ? left : Turn{-right.angle, right.asv};
    Finding worst = at_asv(!(left.angle > e && right.angle < -e), against.asv, e - against.angle);
    keep_worse(worst, at_asv(sharpest.angle != pi, sharpest.asv, pi - std::abs(sharpest.angle)));
    Finding sum;
    sum.ok = total <= 3 * pi;
    sum.offender.room = 3 * pi - total;
    keep_worse(worst, sum);
    return worst;
}

Finding check_area(State state, const Requirements& requirements) {
    const double area = std::abs(geometry::signed_area(state));
    const double least = requirements.min_area(state.size()) - requirements.tolerance;
    Finding finding;
    finding.ok = area >= least;
    finding.offender.room = area - least;
    return finding;
}

Finding check_bounds(State state, const Requirements& requirements) {
    const geometry::Box box = geometry::grown(requirements.bounds, requirements.tolerance);
    Finding worst;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const auto& [x, y] = state[i];
        const bool ok = x >= box.low.x && y >= box.low.y && x < box.high.x && y < box.high.y;
        const double room =
            std::min({x - box.low.x, y - box.low.y, box.high.x - x, box.high.y - y});
        if (worse(ok, room, worst)) worst = at_asv(ok, i, room);
    }
    return worst;
}

}  // namespace asv::core::validation
