#include "core/space/chain_world.hpp"

#include <array>

namespace asv::core {

namespace {

Metric mean_metric(const Problem& problem, const Chain& chain) {
    const std::array<std::vector<Point>, 2> shapes{problem.start, problem.goal};
    return Metric(chain, shapes);
}

}  // namespace

ChainWorld::ChainWorld(const Problem& given, Anchor anchor,
                       const std::shared_ptr<const KeptObstacles>& prepared)
    : problem(given),
      chain(problem.asv_count(), problem.requirements.broom_length, anchor),
      constraints(make_constraints(problem, chain, {}, prepared.get())),
      shared_field(field_of(constraints.obstacles, prepared)),
      field(*shared_field),
      metric(mean_metric(problem, chain)),
      start(chain.dimension()),
      goal(chain.dimension()) {
    chain.configuration(problem.start, start);
    chain.configuration(problem.goal, goal);
}

}  // namespace asv::core
