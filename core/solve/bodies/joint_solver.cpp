#include "core/bounds/lower_bound.hpp"
#include "core/shorten/joint_shortener.hpp"
#include "core/solve/bodies/body_solver.hpp"
#include "core/solve/bodies/mend.hpp"
#include "core/solve/bodies/search_in.hpp"
#include "core/solve/primitive_steps.hpp"
#include "core/space/joint_space.hpp"
#include "core/space/joint_world.hpp"

namespace asv::core {

namespace {

Attempt run(const AutoPlanner&, const JointWorld& world, const Query& query, const Limits& limits,
            Rng& rng, const Observer& observer) {
    JointSpace space(world);
    Attempt attempt;
    attempt.search = rrt_connect(space, query, {}, limits, rng, observer);
    attempt.checks = {space.state_checks(), space.motion_checks()};
    return attempt;
}

/// Of all other planners, which take their samples from a sampler.
template <class Chosen>
Attempt run(const Chosen& planner, const JointWorld& world, const Query& query,
            const Limits& limits, Rng& rng, const Observer& observer) {
    const auto sampler = sampler_for(JointSpace(world), planner.sampler);
    SampledBy<JointSpace> space(sampler, world);
    Attempt attempt;
    attempt.search = search_in(space, planner, query, limits, rng, observer);
    attempt.checks = {space.state_checks(), space.motion_checks()};
    return attempt;
}

/// Microseconds that a search takes besides its checks.
constexpr double search_overhead = 50;
/// Nearer to the lower bound there is nothing to gain, in shares of it.
constexpr double negligible = 1e-5;

class JointSolver : public BodySolver {
  public:
    JointSolver(const Problem& problem, const Planner& planner)
        : planner_(planner), world_(problem) {}

    Attempt search(const Limits& limits, Rng& rng, const Observer& observer,
                   std::size_t /*racer*/) const override {
        return std::visit(
            [&](const auto& chosen) {
                return run(chosen, world_, {world_.start, world_.goal}, limits, rng, observer);
            },
            planner_);
    }

    Attempt mend(const Path& last, const Limits& limits, Rng& rng) const override {
        JointSpace space(world_);
        Attempt attempt;
        const auto search = [&](const Query& query) {
            const auto run_planner = [&](const auto& chosen) {
                return run(chosen, world_, query, limits, rng, {});
            };
            Attempt joint = std::visit(run_planner, planner_);
            attempt.checks += joint.checks;
            return std::move(joint.search);
        };
        const auto valid = [&](auto from, auto to) { return space.motion_valid(from, to); };
        PathMender mender(space, valid, search);
        attempt.search = mender.mend({world_.start, world_.goal}, world_.rows_of(last));
        attempt.checks += {space.state_checks(), space.motion_checks()};
        return attempt;
    }

    double cost(const Configurations& path) const override {
        return path_cost(JointSpace(world_), path);
    }

    Improved improve(const Configurations& path, const ImprovementOrder& order,
                     Rng& rng) const override {
        Improved improved;
        const auto another = [&](Rng& draws) {
            Attempt attempt = search(order.search_limits, draws, {}, 0);
            improved.checks += attempt.checks;
            return AnotherPath{std::move(attempt.search.path), search_work(attempt.checks)};
        };
        ImproveOptions options{.work = order.work,
                               .good_enough = exact_lower_bound() * (1 + negligible),
                               .limits = order.limits,
                               .on_better = order.on_better};
        if (order.other_paths) options.another = another;

        JointSpace space(world_);
        JointShortener shortener(space);
        improved.path = core::improve(path, shortener, options, rng);
        improved.checks += {space.state_checks(), space.motion_checks()};
        return improved;
    }

    std::optional<Path> steps(const Configurations& path,
                              Clock::time_point deadline) const override {
        MotionChecker checker = world_.make_checker();
        return primitive_steps_before(deadline, world_.problem, world_.chain_rows(path), checker);
    }

    std::vector<Point> places(const Tree& tree) const override {
        JointSpace space(world_);
        std::vector<Point> points;
        for (std::uint32_t node = 0; node < tree.size(); ++node)
            points.push_back(space.position(tree.row(node)));
        return points;
    }

  private:
    double search_work(const ChecksSpent& checks) const {
        return search_overhead +
               microseconds(checks.state_checks, checks.edge_checks, world_.dimension());
    }

    /// Of a path that has no use for the tolerance.
    double exact_lower_bound() const {
        Problem exact = world_.problem;
        exact.requirements.tolerance = 0;
        return cost_lower_bound(exact).total;
    }

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
