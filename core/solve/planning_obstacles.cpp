#include "core/solve/planning_obstacles.hpp"

#include "core/space/proof/chain_constraints.hpp"

namespace asv::core {

std::shared_ptr<const KeptObstacles> PlanningObstacles::in(const PlanningFrame& frame) const {
    Seen& seen = seen_[frame.transposed() ? 1 : 0];
    std::call_once(seen.made, [&] {
        const Problem& problem = frame.problem();
        seen.obstacles = std::make_shared<KeptObstacles>(
            problem.obstacles, problem.requirements.tolerance, Margins{}.length);
    });
    return seen.obstacles;
}

std::vector<InvalidEnd> PlanningObstacles::find_invalid_ends(const Problem& problem,
                                                             const PlanningFrame& frame) const {
    const std::shared_ptr<const KeptObstacles> kept = in(frame);
    Path ends(problem.asv_count());
    for (const auto* end : {&problem.start, &problem.goal}) ends.push_back(*end);
    const Path planned = frame.path_in(ends);
    Problem near{problem.start, problem.goal, {}, problem.requirements, problem.body};
    for (std::size_t i = 0; i < planned.size(); ++i)
        kept->field().index().visit(geometry::bounding_box(planned.state(i)), [&](std::size_t box) {
            near.obstacles.push_back(problem.obstacles[kept->numbers()[box]]);
            return false;
        });
    if (invalid_ends(near).empty()) return {};
    return invalid_ends(problem);
}

}  // namespace asv::core
