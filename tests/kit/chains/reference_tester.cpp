#include "tests/kit/chains/reference_tester.hpp"

#include <cmath>
#include <numbers>

#include "geometry/predicates/segment_box.hpp"

namespace asv::test {

namespace {

bool meets_broom_lengths(std::span<const Point> p, double e) {
    for (std::size_t i = 1; i < p.size(); ++i) {
        const double length = std::sqrt((p[i].x - p[i - 1].x) * (p[i].x - p[i - 1].x) +
                                        (p[i].y - p[i - 1].y) * (p[i].y - p[i - 1].y));
        if (std::abs(length - 0.05) > e) return false;
    }
    return true;
}

bool meets_convexity(std::span<const Point> p, double e) {
    constexpr double pi = std::numbers::pi;
    std::vector<Point> walk(p.begin(), p.end());
    walk.push_back(walk[0]);
    walk.push_back(walk[1]);
    std::vector<double> headings;
    for (std::size_t i = 1; i < walk.size(); ++i) {
        headings.push_back(std::atan2(walk[i].y - walk[i - 1].y, walk[i].x - walk[i - 1].x));
    }
    double total = 0;
    double sign = 0;
    for (std::size_t i = 1; i < headings.size(); ++i) {
        double turn = headings[i] - headings[i - 1];
        if (turn <= -pi) turn += 2 * pi;
        if (turn > pi) turn -= 2 * pi;
        if (turn == pi) return false;
        total += std::abs(turn);
        if (std::abs(turn) <= e) continue;
        if (turn * sign < 0) return false;
        sign = turn;
    }
    return total <= 3 * pi;
}

bool meets_area(std::span<const Point> p, double e) {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Point& a = p[i];
        const Point& b = p[(i + 1) % p.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    const double radius = 0.007 * static_cast<double>(p.size() - 1);
    return std::abs(twice / 2) >= std::numbers::pi * radius * radius - e;
}

bool meets_bounds(std::span<const Point> p, double e) {
    for (const auto& [x, y] : p) {
        if (x < -e || y < -e || x >= 1 + e || y >= 1 + e) return false;
    }
    return true;
}

bool meets_collisions(std::span<const Point> p, const std::vector<geometry::Box>& boxes, double e) {
    for (std::size_t i = 1; i < p.size(); ++i) {
        for (const auto& [low, high] : boxes) {
            const geometry::Box shrunk{{low.x + e, low.y + e}, {high.x - e, high.y - e}};
            if (geometry::meets({p[i - 1], p[i]}, shrunk)) return false;
        }
    }
    return true;
}

}  // namespace

std::vector<core::Check> reference_failures(std::span<const Point> state,
                                            const std::vector<geometry::Box>& boxes, double e) {
    std::vector<core::Check> failures;
    if (!meets_broom_lengths(state, e)) failures.push_back(core::Check::broom_lengths);
    if (!meets_convexity(state, e)) failures.push_back(core::Check::convexity);
    if (!meets_area(state, e)) failures.push_back(core::Check::area);
    if (!meets_bounds(state, e)) failures.push_back(core::Check::bounds);
    if (!meets_collisions(state, boxes, e)) failures.push_back(core::Check::collisions);
    return failures;
}

}  // namespace asv::test
