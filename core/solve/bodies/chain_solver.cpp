#include "core/routes/improve_along_routes.hpp"
#include "core/shorten/chain_shortener.hpp"
#include "core/solve/bodies/body_solver.hpp"
#include "core/solve/bodies/least_cost.hpp"
#include "core/solve/bodies/mend.hpp"
#include "core/solve/bodies/search_in.hpp"
#include "core/solve/primitive_steps.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/ladder_space.hpp"
#include "core/space/motion_cost.hpp"
#include "core/space/slide_space.hpp"
#include "core/space/straight_space.hpp"
#include "geometry/free_plane/free_plane.hpp"

namespace asv::core {

namespace {

Attempt run(const AutoPlanner& planner, const ChainWorld& world, const Query& query,
            const Limits& limits, Rng& rng, const Observer& observer) {
    SlideSpace space(world, planner.steering);
    Attempt attempt;
    attempt.search = slide_and_pull(space, query, planner.search, limits, rng, observer);
    attempt.checks = {space.checker().state_checks(), space.checker().motion_checks()};
    attempt.constrained_steps = space.constrained_steps();
    return attempt;
}

/// Of all other planners, which take their samples from a sampler.
template <class Space, class Chosen, class... SpaceOptions>
Attempt run_in(const Chosen& planner, const ChainWorld& world, const Query& query,
               const Limits& limits, Rng& rng, const Observer& observer,
               const SpaceOptions&... options) {
    const auto sampler = sampler_for(Space(world, options...), planner.sampler);
    SampledBy<Space> space(sampler, world, options...);
    Attempt attempt;
    attempt.search = search_in(space, planner, query, limits, rng, observer);
    attempt.checks = {space.state_checks(), space.motion_checks()};
    return attempt;
}

Attempt run(const RrtConnectPlanner& planner, const ChainWorld& world, const Query& query,
            const Limits& limits, Rng& rng, const Observer& observer) {
    return run_in<LadderSpace>(planner, world, query, limits, rng, observer, planner.space);
}

template <class OneOfTheOthers>
Attempt run(const OneOfTheOthers& planner, const ChainWorld& world, const Query& query,
            const Limits& limits, Rng& rng, const Observer& observer) {
    return run_in<StraightSpace>(planner, world, query, limits, rng, observer);
}

/// The space that a planner searches, whose steering joins the pieces of a path.
SlideSpace space_for(const AutoPlanner& planner, const ChainWorld& world) {
    return {world, planner.steering};
}
LadderSpace space_for(const RrtConnectPlanner& planner, const ChainWorld& world) {
    return {world, planner.space};
}
template <class OneOfTheOthers>
StraightSpace space_for(const OneOfTheOthers&, const ChainWorld& world) {
    return StraightSpace(world);
}

/// Every second racer slides in steps of half the length: slower in corridors, twice as fast
/// through clutter.
Planner varied(Planner planner, std::size_t racer) {
    if (auto* chosen = std::get_if<AutoPlanner>(&planner); chosen && racer % 2 == 1)
        chosen->steering.step /= 2;
    return planner;
}

Anchor anchor_of(const Planner& planner) {
    return std::holds_alternative<RrtConnectPlanner>(planner) ? Anchor::first_asv
                                                              : Anchor::centroid;
}

/// A lone ASV has no broom that could collide, so that nothing forbids it to cross obstacles; it
/// goes round them as chains do where there is a way round, and straight ahead where there is none:
/// it has obstacles of its own.
Problem kept_off_obstacles(Problem problem) {
    if (problem.asv_count() > 1) return problem;
    std::vector<Box> kept_off;
    for (const Box& box : problem.obstacles)
        kept_off.push_back(geometry::grown(box, problem.requirements.tolerance));
    geometry::FreePlane plane(kept_off, problem.requirements.bounds);
    const Point &start = problem.start[0], &goal = problem.goal[0];
    if (!plane.is_free(start) || !plane.is_free(goal) || !plane.connected(start, goal))
        problem.obstacles.clear();
    return problem;
}

class ChainSolver : public BodySolver {
  public:
    ChainSolver(const Problem& problem, const Planner& planner,
                const std::shared_ptr<const KeptObstacles>& prepared)
        : planner_(planner),
          world_(kept_off_obstacles(problem), anchor_of(planner),
                 problem.asv_count() > 1 ? prepared : nullptr) {}

    Attempt search(const Limits& limits, Rng& rng, const Observer& observer,
                   std::size_t racer) const override {
        const Planner planner = varied(planner_, racer);
        return std::visit(
            [&](const auto& chosen) { return run(chosen, world_, ends(), limits, rng, observer); },
            planner);
    }

    Attempt mend(const Path& last, const Limits& limits, Rng& rng) const override {
        return std::visit([&](const auto& chosen) { return mend_with(chosen, last, limits, rng); },
                          planner_);
    }

    double cost(const Configurations& path) const override {
        return MotionCost(world_.chain).path(path);
    }

    Improved improve(const Configurations& path, const ImprovementOrder& order,
                     Rng& rng) const override {
        Improved improved;
        const auto another = [&](Rng& draws, double patience) {
            Attempt attempt = search(with_patience(order.search_limits, patience), draws, {}, 0);
            improved.checks += attempt.checks;
            return AnotherPath{std::move(attempt.search.path), search_work(attempt)};
        };
        ImproveOptions options{
            .work = order.work, .limits = order.limits, .on_better = order.on_better};
        if (order.other_paths)
            options.good_enough = nothing_to_gain_below(world_.problem, order.work);

        MotionChecker checker = world_.make_checker();
        const auto* sliding = std::get_if<AutoPlanner>(&planner_);
        SlideSteering steering(checker, world_.metric,
                               sliding ? sliding->steering : SlideOptions{});
        ChainShortener shortener(checker, world_.metric, steering);
        if (sliding && order.other_paths) {
            RouteSearch routes(world_, {sliding->steering, sliding->search, order.search_limits});
            improved.path = improve_along_routes(path, world_, shortener, routes, options, rng);
            improved.checks += {routes.state_checks(), routes.motion_checks()};
        } else {
            if (order.other_paths) options.another = another;
            improved.path = core::improve(path, shortener, options, rng);
        }
        improved.optimal = cost(improved.path) <= options.good_enough;
        improved.checks += {checker.state_checks(), checker.motion_checks()};
        return improved;
    }

    std::optional<Path> steps(const Configurations& path,
                              Clock::time_point deadline) const override {
        MotionChecker checker = world_.make_checker();
        return primitive_steps_before(deadline, world_.problem, path, checker);
    }

    std::vector<Placement> placements(const Configurations& path) const override {
        const std::size_t d = world_.chain.dimension();
        Pose pose = world_.chain.make_pose();
        std::vector<Placement> found(path.size() / d);
        for (std::size_t i = 0; i < found.size(); ++i) {
            world_.chain.forward({path.data() + i * d, d}, pose);
            for (std::size_t j = 0; j < pose.x.size(); ++j)
                found[i].points.push_back({pose.x[j], pose.y[j]});
        }
        found.front().points = world_.problem.start;
        found.back().points = world_.problem.goal;
        return found;
    }

    std::vector<Point> places(const Tree& tree) const override {
        Pose pose = world_.chain.make_pose();
        std::vector<Point> points;
        for (std::uint32_t node = 0; node < tree.size(); ++node) {
            world_.chain.forward(tree.row(node), pose);
            points.push_back({pose.x[0], pose.y[0]});
        }
        return points;
    }

  private:
    Query ends() const { return {world_.start, world_.goal}; }

    template <class Chosen>
    Attempt mend_with(const Chosen& planner, const Path& last, const Limits& limits,
                      Rng& rng) const {
        auto space = space_for(planner, world_);
        MotionChecker checker = world_.make_checker();
        Attempt attempt;
        const auto search = [&](const Query& query) {
            Attempt joint = run(planner, world_, query, limits, rng, {});
            attempt.checks += joint.checks;
            return std::move(joint.search);
        };
        const auto valid = [&](auto from, auto to) { return checker.valid(from, to); };
        PathMender mender(space, valid, search);
        attempt.search = mender.mend(ends(), rows_of(last, space.wrapping()));
        attempt.checks += {checker.state_checks(), checker.motion_checks()};
        return attempt;
    }

    /// The configurations of a path, their angles unwrapped alike.
    Configurations rows_of(const Path& path, WrappingAngles angles) const {
        std::vector<double> row(world_.start), before(world_.start);
        Configurations rows;
        for (std::size_t i = 0; i < path.size(); ++i) {
            world_.chain.configuration(path.state(i), row);
            unwrap(row, before, angles);
            rows.insert(rows.end(), row.begin(), row.end());
            before = row;
        }
        return rows;
    }

    double search_work(const Attempt& attempt) const {
        const ChainWork done{attempt.checks.state_checks, attempt.constrained_steps, 0};
        return microseconds(done, world_.problem.asv_count(), world_.problem.obstacles.size());
    }

    const Planner& planner_;
    ChainWorld world_;
};

}  // namespace

std::unique_ptr<BodySolver> make_chain_solver(
    const Problem& problem, const Planner& planner,
    const std::shared_ptr<const KeptObstacles>& prepared) {
    return std::make_unique<ChainSolver>(problem, planner, prepared);
}

}  // namespace asv::core
