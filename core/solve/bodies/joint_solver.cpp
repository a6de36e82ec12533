#include "core/bounds/lower_bound.hpp"
#include "core/shorten/improve_joints.hpp"
#include "core/solve/bodies/body_solver.hpp"
#include "core/solve/bodies/search_in.hpp"
#include "core/solve/primitive_steps.hpp"
#include "core/space/joint_space.hpp"
#include "core/space/joint_world.hpp"

namespace asv::core {

namespace {

Attempt run(const AutoPlanner&, const JointWorld& world, const Limits& limits, Rng& rng,
            const Observer& observer) {
    JointSpace space(world);
    Attempt attempt;
    attempt.search = rrt_connect(space, {world.start, world.goal}, {}, limits, rng, observer);
    attempt.state_checks = space.state_checks();
    attempt.edge_checks = space.motion_checks();
    return attempt;
}

/// Of all other planners, which take their samples from a sampler.
template <class Chosen>
Attempt run(const Chosen& planner, const JointWorld& world, const Limits& limits, Rng& rng,
            const Observer& observer) {
    const auto sampler = sampler_for(JointSpace(world), planner.sampler);
    SampledBy<JointSpace> space(sampler, world);
    Attempt attempt;
    attempt.search = search_in(space, planner, {world.start, world.goal}, limits, rng, observer);
    attempt.state_checks = space.state_checks();
    attempt.edge_checks = space.motion_checks();
    return attempt;
}

/// Microseconds that a search takes besides its checks.
constexpr double work_of_search = 50;

class JointSolver : public BodySolver {
  public:
    JointSolver(const Problem& problem, const Planner& planner)
        : problem_(problem), planner_(planner), world_(problem) {}

    Attempt search(const Limits& limits, Rng& rng, const Observer& observer,
                   std::size_t /*racer*/) const override {
        return std::visit(
            [&](const auto& chosen) { return run(chosen, world_, limits, rng, observer); },
            planner_);
    }

    double cost(const Configurations& path) const override {
        return path_cost(JointSpace(world_), path);
    }

    Configurations improve(const Configurations& path, const ImprovementOrder& order, Rng& rng,
                           Attempt& spent) const override {
        JointSpace space(world_);
        const auto another = [&](Rng& draws) {
            Attempt attempt = search(order.search_limits, draws, {}, 0);
            spent.state_checks += attempt.state_checks;
            spent.edge_checks += attempt.edge_checks;
            return AnotherPath{
                std::move(attempt.search.path),
                work_of_search +
                    joint_work_of(attempt.state_checks, attempt.edge_checks, world_.dimension())};
        };
        Configurations rows = improve_joints(
            path, space, order.other_paths ? another : std::function<AnotherPath(Rng&)>{},
            lower_bound(), order.work, order.limits, rng, order.on_better);
        spent.state_checks += space.state_checks();
        spent.edge_checks += space.motion_checks();
        return rows;
    }

    Path steps(const Configurations& path) const override {
        MotionChecker checker = world_.make_checker();
        return primitive_steps(world_.problem, world_.chain_rows(path), checker);
    }

    std::vector<Point> places(const Tree& tree) const override {
        JointSpace space(world_);
        std::vector<Point> points;
        for (std::uint32_t node = 0; node < tree.size(); ++node)
            points.push_back(space.position(tree.row(node)));
        return points;
    }

  private:
    /// Of a path that has no use for the tolerance.
    double lower_bound() const {
        Problem exact = problem_;
        exact.requirements.tolerance = 0;
        return cost_lower_bound(exact).total;
    }

    const Problem& problem_;
    const Planner& planner_;
    JointWorld world_;
};

}  // namespace

std::unique_ptr<BodySolver> make_joint_solver(const Problem& problem, const Planner& planner) {
    return std::make_unique<JointSolver>(problem, planner);
}

std::unique_ptr<BodySolver> make_body_solver(const Problem& problem, const Planner& planner) {
    return problem.body_kind() == BodyKind::chain ? make_chain_solver(problem, planner)
                                                  : make_joint_solver(problem, planner);
}

}  // namespace asv::core
