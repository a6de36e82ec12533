#include "tests/kit/chains/wall_of_two.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/kit/chains/chains.hpp"

namespace asv::test {

namespace {

constexpr double broom = 0.05;
constexpr double radius = 0.02;
constexpr double quarter = radius * std::numbers::pi / 2;
// Straight from one broom's length before the wall to one behind it, so that no broom is in the
// wall with one end and in a bend with the other.
constexpr double west = 0.45;
constexpr double east = 0.65;

/// What the chain follows: straight down, along the line on which the boxes touch, straight up.
/// `distance` is measured along it from where it reaches the line.
Point on_curve(double distance) {
    if (distance < -quarter) return {west - radius, 0.5 + radius - distance - quarter};
    if (distance < 0) {
        const double angle = distance / radius;
        return {west + radius * std::sin(angle), 0.5 + radius * (1 - std::cos(angle))};
    }
    const double past = distance - (east - west);
    if (past < 0) return {west + distance, 0.5};
    if (past < quarter) {
        const double angle = past / radius;
        return {east + radius * std::sin(angle), 0.5 + radius * (1 - std::cos(angle))};
    }
    return {east + radius, 0.5 + radius + past - quarter};
}

/// The chain with its last ASV (the leader) there and the others behind it on the curve.
Points chain_at(std::size_t asv_count, double leader) {
    Points chain(asv_count);
    double place = leader;
    for (std::size_t i = asv_count; i-- > 0;) {
        chain[i] = on_curve(place);
        double near = place;
        double far = place - 1.5 * broom;
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = (near + far) / 2;
            const Point next = on_curve(middle);
            const bool short_of = std::hypot(next.x - chain[i].x, next.y - chain[i].y) < broom;
            (short_of ? near : far) = middle;
        }
        place = near;
    }
    return chain;
}

double leader_at_start() {
    return 0.495 - west;
}

/// Its first ASV is then as far behind the wall as the leader was before it.
double leader_at_goal(std::size_t asv_count) {
    double leader = 0;
    while (chain_at(asv_count, leader).front().x < 0.605) leader += 0.001;
    return leader;
}

}  // namespace

core::Problem wall_of_two(std::size_t asv_count, double top) {
    core::Problem problem;
    problem.start = chain_at(asv_count, leader_at_start());
    problem.goal = chain_at(asv_count, leader_at_goal(asv_count));
    problem.obstacles = {{{0.5, 0}, {0.6, 0.5}}, {{0.5, 0.5}, {0.6, top}}};
    return problem;
}

core::Solution squeeze_through(const core::Problem& problem) {
    const std::size_t asv_count = problem.asv_count();
    const double begin = leader_at_start();
    const double end = leader_at_goal(asv_count);
    core::Solution solution{core::Path(asv_count), 0};
    Points last = problem.start;
    solution.path.push_back(last);
    // In a bend a follower is up to six times as fast as its leader.
    constexpr int steps = 5000;
    for (int i = 1; i <= steps; ++i) {
        const Points next = chain_at(asv_count, begin + (end - begin) * i / steps);
        for (std::size_t asv = 0; asv < asv_count; ++asv) {
            solution.cost += std::hypot(next[asv].x - last[asv].x, next[asv].y - last[asv].y);
        }
        solution.path.push_back(next);
        last = next;
    }
    return solution;
}

}  // namespace asv::test
