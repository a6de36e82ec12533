#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "io/text/scanner.hpp"

/// Random values that a file can hold; they mean nothing to a planner.

namespace asv::test {

/// Half of them in [0, 1), half with any bits that give a number a file may hold.
inline double random_number(std::mt19937_64& random) {
    if (random() % 2 == 0) return std::uniform_real_distribution<double>(0, 1)(random);
    while (true) {
        const double value = std::bit_cast<double>(random());
        if (std::isfinite(value) && std::abs(value) <= io::largest_number) return value;
    }
}

inline geometry::Point random_point(std::mt19937_64& random) {
    const double x = random_number(random);
    return {x, random_number(random)};
}

inline std::vector<geometry::Point> random_points(std::mt19937_64& random, std::size_t count) {
    std::vector<geometry::Point> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(random_point(random));
    return points;
}

inline core::Problem random_problem(std::mt19937_64& random) {
    const std::size_t asv_count = 1 + random() % 6;
    core::Problem problem;
    problem.start = random_points(random, asv_count);
    problem.goal = random_points(random, asv_count);
    for (std::size_t i = random() % 5; i > 0; --i) {
        const geometry::Point a = random_point(random);
        const geometry::Point b = random_point(random);
        problem.obstacles.push_back(
            {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}});
    }
    return problem;
}

inline core::Solution random_solution(std::mt19937_64& random, std::size_t asv_count) {
    core::Solution solution{core::Path(asv_count), random_number(random)};
    for (std::size_t i = 1 + random() % 8; i > 0; --i) {
        solution.path.push_back(random_points(random, asv_count));
    }
    return solution;
}

}  // namespace asv::test
