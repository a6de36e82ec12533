#include "core/solve/scaled_problem.hpp"

#include <cmath>
#include <vector>

namespace asv::core {

namespace {

void scale(Point& point, double factor) {
    point.x *= factor;
    point.y *= factor;
}

void scale(Box& box, double factor) {
    scale(box.low, factor);
    scale(box.high, factor);
}

}  // namespace

double unit_of(const Problem& problem) {
    constexpr double classic = Requirements{}.broom_length;
    return std::exp2(std::round(std::log2(problem.requirements.broom_length / classic)));
}

Problem in_units(Problem problem, double unit) {
    const double factor = 1 / unit;
    for (auto* points : {&problem.start, &problem.goal})
        for (Point& point : *points) scale(point, factor);
    for (Box& box : problem.obstacles) scale(box, factor);
    Requirements& required = problem.requirements;
    scale(required.bounds, factor);
    for (double* length : {&required.broom_length, &required.max_step,
                           &required.area_radius_per_broom, &required.tolerance})
        *length *= factor;
    return problem;
}

Path out_of_units(const Path& path, double unit) {
    Path result(path.asv_count());
    result.reserve(path.size());
    std::vector<Point> state;
    for (std::size_t i = 0; i < path.size(); ++i) {
        state.assign(path.state(i).begin(), path.state(i).end());
        for (Point& point : state) scale(point, unit);
        result.push_back(state);
    }
    return result;
}

}  // namespace asv::core
