#include "core/shorten/joint_shortener.hpp"
#include "core/solve/bodies/body_solver.hpp"
#include "core/solve/bodies/least_cost.hpp"
#include "core/solve/bodies/mend.hpp"
#include "core/solve/bodies/point_geodesic.hpp"
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

/// A path that was found without a search, with a tree of its way points alone.
Attempt found_path(const JointWorld& world, const Configurations& path) {
    Attempt attempt;
    attempt.search.outcome = Outcome::solved;
    attempt.search.path = path;
    Tree tree(JointSpace(world).make_index());
    const std::size_t d = world.dimension();
    for (std::size_t i = 0; i < path.size() / d; ++i)
        tree.add({path.data() + i * d, d}, i == 0 ? Tree::none : static_cast<std::uint32_t>(i - 1));
    attempt.search.trees.push_back(std::move(tree));
    return attempt;
}

class JointSolver : public BodySolver {
  public:
    JointSolver(const Problem& problem, const Planner& planner,
                const std::shared_ptr<const KeptObstacles>& prepared)
        : planner_(planner), world_(problem, prepared) {
        if (std::holds_alternative<AutoPlanner>(planner) && problem.body_kind() == BodyKind::point)
            geodesic_ = point_geodesic(world_);
    }

    Attempt search(const Limits& limits, Rng& rng, const Observer& observer,
                   std::size_t /*racer*/) const override {
        if (!geodesic_.empty()) return found_path(world_, geodesic_);
        return search_with(planner_, ends(), limits, rng, observer);
    }

    Attempt mend(const Path& last, const Limits& limits, Rng& rng) const override {
        if (!geodesic_.empty()) return found_path(world_, geodesic_);
        JointSpace space(world_);
        Attempt attempt;
        const auto search = [&](const Query& query) {
            Attempt joint = search_with(planner_, query, limits, rng, {});
            attempt.checks += joint.checks;
            return std::move(joint.search);
        };
        const auto valid = [&](auto from, auto to) { return space.motion_valid(from, to); };
        PathMender mender(space, valid, search);
        attempt.search = mender.mend(ends(), world_.rows_of(last));
        attempt.checks += {space.state_checks(), space.motion_checks()};
        return attempt;
    }

    double cost(const Configurations& path) const override {
        return path_cost(JointSpace(world_), path);
    }

    Improved improve(const Configurations& path, const ImprovementOrder& order,
                     Rng& rng) const override {
        if (!geodesic_.empty()) return {geodesic_, {}, true};
        Improved improved;
        // Two trees find a path soon, a roadmap, where it finds one, a shorter path.
        const Planner roadmap = PrmRandomPlanner{};
        const bool varied = std::holds_alternative<AutoPlanner>(planner_);
        bool by_trees = false;
        const auto another = [&](Rng& draws, double patience) {
            const Planner& planner = varied && !by_trees ? roadmap : planner_;
            const Limits limits = with_patience(order.search_limits, patience);
            Attempt attempt = search_with(planner, ends(), limits, draws, {});
            improved.checks += attempt.checks;
            by_trees = !by_trees && attempt.search.path.empty();
            return AnotherPath{std::move(attempt.search.path), search_work(attempt.checks)};
        };
        ImproveOptions options{.work = order.work,
                               .good_enough = nothing_to_gain_below(world_.problem),
                               .limits = order.limits,
                               .on_better = order.on_better};
        if (order.other_paths) options.another = another;

        JointSpace space(world_);
        JointShortener shortener(space);
        improved.path = core::improve(path, shortener, options, rng);
        improved.optimal = cost(improved.path) <= options.good_enough;
        improved.checks += {space.state_checks(), space.motion_checks()};
        return improved;
    }

    std::optional<Path> steps(const Configurations& path,
                              Clock::time_point deadline) const override {
        MotionChecker checker = world_.make_checker();
        return primitive_steps_before(deadline, world_.problem, world_.chain_rows(path), checker);
    }

    std::vector<Placement> placements(const Configurations& path) const override {
        const std::size_t d = world_.dimension();
        std::vector<Placement> found;
        for (std::size_t i = 0; i < path.size() / d; ++i)
            found.push_back(world_.placement({path.data() + i * d, d}));
        return found;
    }

    std::vector<Point> places(const Tree& tree) const override {
        JointSpace space(world_);
        std::vector<Point> points;
        for (std::uint32_t node = 0; node < tree.size(); ++node)
            points.push_back(space.position(tree.row(node)));
        return points;
    }

  private:
    Query ends() const { return {world_.start, world_.goal}; }

    Attempt search_with(const Planner& planner, const Query& query, const Limits& limits, Rng& rng,
                        const Observer& observer) const {
        return std::visit(
            [&](const auto& chosen) { return run(chosen, world_, query, limits, rng, observer); },
            planner);
    }

    double search_work(const ChecksSpent& checks) const {
        return search_overhead +
               microseconds(checks.state_checks, checks.edge_checks, world_.dimension());
    }

    const Planner& planner_;
    JointWorld world_;
    Configurations geodesic_;  ///< the shortest path, where it is known without a search
};

}  // namespace

std::unique_ptr<BodySolver> make_joint_solver(
    const Problem& problem, const Planner& planner,
    const std::shared_ptr<const KeptObstacles>& prepared) {
    return std::make_unique<JointSolver>(problem, planner, prepared);
}

std::unique_ptr<BodySolver> make_body_solver(const Problem& problem, const Planner& planner,
                                             const std::shared_ptr<const KeptObstacles>& prepared) {
    return problem.body_kind() == BodyKind::chain ? make_chain_solver(problem, planner, prepared)
                                                  : make_joint_solver(problem, planner, prepared);
}

}  // namespace asv::core
