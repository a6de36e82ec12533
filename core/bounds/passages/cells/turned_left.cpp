#include "core/bounds/passages/cells/turned_left.hpp"

#include <utility>

#include "geometry/predicates/polygon.hpp"

namespace asv::core {

TurnedLeft turned_left(Problem problem) {
    const bool turns_right = geometry::signed_area(problem.start) < 0;
    if (!turns_right) return {std::move(problem), false};
    for (auto* state : {&problem.start, &problem.goal})
        for (Point& point : *state) std::swap(point.x, point.y);
    for (Box& box : problem.obstacles) box = transposed(box);
    problem.requirements.bounds = transposed(problem.requirements.bounds);
    return {std::move(problem), true};
}

}  // namespace asv::core
