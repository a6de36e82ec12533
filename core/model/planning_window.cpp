#include "core/model/planning_window.hpp"

#include <algorithm>

namespace asv::core {

namespace {

/// Around what there is, room for so many times the body's own length, and for so large a share of
/// the longer side.
constexpr double bodies_of_room = 2;
constexpr double share_of_room = 0.25;

void include(Box& hull, const Box& box) {
    hull.low = {std::min(hull.low.x, box.low.x), std::min(hull.low.y, box.low.y)};
    hull.high = {std::max(hull.high.x, box.high.x), std::max(hull.high.y, box.high.y)};
}

}  // namespace

Box planning_window(const Problem& problem) {
    if (problem.requirements.bounded()) return problem.requirements.bounds;
    const Point& base = problem.start[0];
    // More than the tolerance, so that an arm that is stretched out keeps clear of the border.
    if (const PlanarArm* arm = problem.arm())
        return geometry::grown(Box{base, base}, 1.01 * total_length(*arm));
    Box hull{base, base};
    for (const auto* points : {&problem.start, &problem.goal})
        for (const Point& point : *points) include(hull, {point, point});
    for (const Box& box : problem.obstacles) include(hull, box);
    const double longer = std::max(hull.high.x - hull.low.x, hull.high.y - hull.low.y);
    const double body =
        problem.requirements.broom_length * static_cast<double>(problem.asv_count() - 1);
    return geometry::grown(
        hull, bodies_of_room * body + share_of_room * longer + problem.requirements.max_step);
}

Problem bounded(Problem problem) {
    problem.requirements.bounds = planning_window(problem);
    return problem;
}

}  // namespace asv::core
