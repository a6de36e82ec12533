#include "core/space/chain_world.hpp"

#include <array>
#include <utility>

#include "geometry/predicates/polygon.hpp"

namespace asv::core {

namespace {

Problem counter_clockwise(const Problem& problem, bool clockwise) {
    return clockwise ? transposed(problem) : problem;
}

Metric mean_metric(const Problem& problem, const Chain& chain) {
    const std::array<std::vector<Point>, 2> shapes{problem.start, problem.goal};
    return Metric(chain, shapes);
}

}  // namespace

Problem transposed(Problem problem) {
    const auto swap = [](Point& p) { std::swap(p.x, p.y); };
    for (auto* positions : {&problem.start, &problem.goal})
        for (Point& p : *positions) swap(p);
    for (Box& box : problem.obstacles) {
        swap(box.low);
        swap(box.high);
    }
    swap(problem.requirements.bounds.low);
    swap(problem.requirements.bounds.high);
    return problem;
}

ChainWorld::ChainWorld(const Problem& given, Anchor anchor)
    : transposed(geometry::signed_area(given.start) < 0),
      problem(counter_clockwise(given, transposed)),
      chain(problem.asv_count(), problem.requirements.broom_length, anchor),
      constraints(make_constraints(problem, chain)),
      field(constraints.obstacles),
      metric(mean_metric(problem, chain)),
      start(chain.dimension()),
      goal(chain.dimension()) {
    chain.configuration(problem.start, start);
    chain.configuration(problem.goal, goal);
}

}  // namespace asv::core
