#include "tests/core/validation/path_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "tests/kit/geometry/exact_oracle.hpp"

namespace asv::test {

namespace {

using geometry::Box;
using geometry::Point;
using Real = long double;
using State = std::span<const Point>;

constexpr Real pi = std::numbers::pi_v<Real>;

Real length(const Point& a, const Point& b) {
    return std::hypot(static_cast<Real>(b.x) - a.x, static_cast<Real>(b.y) - a.y);
}

/// The room that is left, and whether it can be told from none.
Verdict verdict(Real room, Real doubt) {
    if (std::abs(room) <= doubt) return Verdict::in_doubt;
    return room > 0 ? Verdict::holds : Verdict::fails;
}

Real farthest(State a, State b) {
    Real most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i], b[i]));
    return most;
}

Real worst_broom(State state, Real wanted) {
    Real worst = 0;
    for (std::size_t i = 1; i < state.size(); ++i)
        worst = std::max(worst, std::abs(length(state[i - 1], state[i]) - wanted));
    return worst;
}

/// From the directions of two sides to the angle between them, without any heading.
Real turn(const Point& a, const Point& b, const Point& c) {
    const Real ux = static_cast<Real>(b.x) - a.x, uy = static_cast<Real>(b.y) - a.y;
    const Real vx = static_cast<Real>(c.x) - b.x, vy = static_cast<Real>(c.y) - b.y;
    return std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
}

Verdict convexity(State state, Real e) {
    constexpr Real doubt = 1e-12L;
    const std::size_t n = state.size();
    Real left = -pi, right = pi, sharpest = 0, total = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Real angle = turn(state[i], state[(i + 1) % n], state[(i + 2) % n]);
        left = std::max(left, angle);
        right = std::min(right, angle);
        sharpest = std::max(sharpest, std::abs(angle));
        total += std::abs(angle);
    }
    // A turn of pi may be one to either side.
    if (pi - sharpest <= doubt) return Verdict::in_doubt;
    return verdict(std::min(e - std::min(left, -right), 3 * pi - total), doubt);
}

Real area(State state) {
    Real twice = 0;
    const Point& origin = state[0];
    for (std::size_t i = 1; i + 1 < state.size(); ++i) {
        const Point &a = state[i], &b = state[i + 1];
        twice += (static_cast<Real>(a.x) - origin.x) * (static_cast<Real>(b.y) - origin.y) -
                 (static_cast<Real>(a.y) - origin.y) * (static_cast<Real>(b.x) - origin.x);
    }
    return std::abs(twice) / 2;
}

Real room_in(const Box& bounds, State state, Real e) {
    Real room = std::numeric_limits<Real>::infinity();
    for (const Point& p : state)
        room = std::min({room, p.x - (bounds.low.x - e), p.y - (bounds.low.y - e),
                         bounds.high.x + e - p.x, bounds.high.y + e - p.y});
    return room;
}

bool collides(State state, const std::vector<Box>& boxes, double e) {
    for (std::size_t i = 1; i < state.size(); ++i)
        for (const Box& box : boxes) {
            const Box shrunk = geometry::grown(box, -e);
            if (!geometry::is_empty(shrunk) && exact_meets({state[i - 1], state[i]}, shrunk))
                return true;
        }
    return false;
}

/// One state that fails makes a path fail; else one in doubt leaves it in doubt.
void keep_worse(Verdict& all, Verdict one) {
    if (one == Verdict::fails || all == Verdict::holds) all = one == Verdict::holds ? all : one;
}

}  // namespace

std::array<Verdict, core::check_count> oracle_verdicts(const core::Problem& problem,
                                                       const core::Solution& solution, double e) {
    constexpr Real doubt = 1e-15L, doubt_of_sums = 1e-11L;
    const core::Requirements& required = problem.requirements;
    const core::Path& path = solution.path;
    std::array<Verdict, core::check_count> verdicts{};
    const auto note = [&](core::Check check, Verdict one) {
        keep_worse(verdicts[static_cast<std::size_t>(check)], one);
    };
    Real cost = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const State state = path.state(i);
        note(core::Check::broom_lengths,
             verdict(e - worst_broom(state, required.broom_length), doubt));
        note(core::Check::convexity, convexity(state, e));
        note(
            core::Check::area,
            verdict(area(state) - (required.min_area(state.size()) - static_cast<Real>(e)), doubt));
        note(core::Check::bounds, verdict(room_in(required.bounds, state, e), doubt));
        note(core::Check::collisions,
             collides(state, problem.obstacles, e) ? Verdict::fails : Verdict::holds);
        if (i == 0) continue;
        const State before = path.state(i - 1);
        note(core::Check::steps,
             verdict(required.max_step + static_cast<Real>(e) - farthest(before, state), doubt));
        for (std::size_t k = 0; k < state.size(); ++k) cost += length(before[k], state[k]);
    }
    for (const auto& [state, wanted] :
         {std::pair(path.state(0), State(problem.start)),
          std::pair(path.state(path.size() - 1), State(problem.goal))}) {
        const Real off = farthest(state, wanted);
        // No rounding makes equal numbers differ.
        note(core::Check::ends, off == 0 ? Verdict::holds : verdict(e - off, doubt));
    }
    note(core::Check::cost, verdict(e - std::abs(solution.cost - cost), doubt_of_sums));
    return verdicts;
}

}  // namespace asv::test
