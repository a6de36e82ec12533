#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "io/drawing/exhibit.hpp"

/// Small problems and solutions for the tests of pictures and players.
namespace asv::test {

using geometry::Box;
using geometry::Point;

/// ASVs on an arc that turns by 4.2 in all, which encloses enough area; the first at the place.
inline std::vector<Point> arc(std::size_t asv_count, Point place) {
    std::vector<Point> points{place};
    double heading = 0;
    for (std::size_t i = 1; i < asv_count; ++i) {
        const Point& last = points.back();
        points.push_back({last.x + 0.05 * std::cos(heading), last.y + 0.05 * std::sin(heading)});
        heading += 4.2 / static_cast<double>(asv_count);
    }
    return points;
}

/// The arc moves along the way points, each ASV by at most the given step.
inline core::Solution translated_arc(std::size_t asv_count, const std::vector<Point>& way,
                                     double step = 0.001) {
    core::Solution solution{core::Path(asv_count), 0};
    solution.path.push_back(arc(asv_count, way.front()));
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double length = std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y);
        const auto count = static_cast<std::size_t>(std::ceil(length / step));
        for (std::size_t k = 1; k <= count; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(count);
            solution.path.push_back(arc(asv_count, {std::lerp(way[i - 1].x, way[i].x, t),
                                                    std::lerp(way[i - 1].y, way[i].y, t)}));
        }
        solution.cost += length * static_cast<double>(asv_count);
    }
    return solution;
}

/// An arc on its way among obstacles, from the first way point to the last.
inline io::ExhibitInput sample(std::size_t asv_count, const std::vector<Point>& way,
                               std::vector<Box> obstacles, double step = 0.001) {
    core::Solution solution = translated_arc(asv_count, way, step);
    io::ExhibitInput input;
    input.name = "sample";
    input.problem.start = arc(asv_count, way.front());
    input.problem.goal = arc(asv_count, way.back());
    input.problem.obstacles = std::move(obstacles);
    input.solution = std::move(solution);
    return input;
}

}  // namespace asv::test
