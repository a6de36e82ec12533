#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/model/problem.hpp"
#include "core/validation/validate.hpp"
#include "geometry/predicates/segment_box.hpp"

/// The requirements once more, written down as plainly as possible and without any shortcut: what
/// the validator is compared with.

namespace asv::test {

inline bool reference_broom_lengths(std::span<const geometry::Point> p, double e) {
    for (std::size_t i = 1; i < p.size(); ++i) {
        const double length = std::sqrt((p[i].x - p[i - 1].x) * (p[i].x - p[i - 1].x) +
                                        (p[i].y - p[i - 1].y) * (p[i].y - p[i - 1].y));
        if (std::abs(length - 0.05) > e) return false;
    }
    return true;
}

inline bool reference_convexity(std::span<const geometry::Point> p, double e) {
    constexpr double pi = std::numbers::pi;
    std::vector<geometry::Point> walk(p.begin(), p.end());
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

inline bool reference_area(std::span<const geometry::Point> p, double e) {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const geometry::Point& a = p[i];
        const geometry::Point& b = p[(i + 1) % p.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    const double radius = 0.007 * static_cast<double>(p.size() - 1);
    return std::abs(twice / 2) >= std::numbers::pi * radius * radius - e;
}

inline bool reference_bounds(std::span<const geometry::Point> p, double e) {
    for (const auto& [x, y] : p) {
        if (x < -e || y < -e || x >= 1 + e || y >= 1 + e) return false;
    }
    return true;
}

inline bool reference_collisions(std::span<const geometry::Point> p,
                                 const std::vector<geometry::Box>& boxes, double e) {
    for (std::size_t i = 1; i < p.size(); ++i) {
        for (const auto& [low, high] : boxes) {
            const geometry::Box shrunk{{low.x + e, low.y + e}, {high.x - e, high.y - e}};
            if (geometry::meets({p[i - 1], p[i]}, shrunk)) return false;
        }
    }
    return true;
}

/// The checks of a state that fail, in the order of the report.
inline std::vector<core::Check> reference_failures(std::span<const geometry::Point> state,
                                                   const std::vector<geometry::Box>& boxes,
                                                   double e) {
    std::vector<core::Check> failures;
    if (!reference_broom_lengths(state, e)) failures.push_back(core::Check::broom_lengths);
    if (!reference_convexity(state, e)) failures.push_back(core::Check::convexity);
    if (!reference_area(state, e)) failures.push_back(core::Check::area);
    if (!reference_bounds(state, e)) failures.push_back(core::Check::bounds);
    if (!reference_collisions(state, boxes, e)) failures.push_back(core::Check::collisions);
    return failures;
}

}  // namespace asv::test
