#include "core/model/planning_window.hpp"
#include "core/shorten/improve.hpp"
#include "core/solve/bodies/body_solver.hpp"
#include "core/solve/bodies/search_in.hpp"
#include "core/solve/primitive_steps.hpp"
#include "core/solve/scaled_problem.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/ladder_space.hpp"
#include "core/space/motion_cost.hpp"
#include "core/space/slide_space.hpp"
#include "core/space/straight_space.hpp"
#include "geometry/free_plane/free_plane.hpp"

namespace asv::core {

namespace {

Attempt run(const AutoPlanner& planner, const ChainWorld& world, const Limits& limits, Rng& rng,
            const Observer& observer) {
    SlideSpace space(world, planner.steering);
    Attempt attempt;
    attempt.search =
        slide_and_pull(space, {world.start, world.goal}, planner.search, limits, rng, observer);
    attempt.state_checks = space.checker().state_checks();
    attempt.edge_checks = space.checker().motion_checks();
    attempt.constrained_steps = space.constrained_steps();
    return attempt;
}

/// Of all other planners, which take their samples from a sampler.
template <class Space, class Chosen, class... SpaceOptions>
Attempt run_in(const Chosen& planner, const ChainWorld& world, const Limits& limits, Rng& rng,
               const Observer& observer, const SpaceOptions&... options) {
    const auto sampler = sampler_for(Space(world, options...), planner.sampler);
    SampledBy<Space> space(sampler, world, options...);
    Attempt attempt;
    attempt.search = search_in(space, planner, {world.start, world.goal}, limits, rng, observer);
    attempt.state_checks = space.state_checks();
    attempt.edge_checks = space.motion_checks();
    return attempt;
}

Attempt run(const RrtConnectPlanner& planner, const ChainWorld& world, const Limits& limits,
            Rng& rng, const Observer& observer) {
    return run_in<LadderSpace>(planner, world, limits, rng, observer, planner.space);
}

template <class OneOfTheOthers>
Attempt run(const OneOfTheOthers& planner, const ChainWorld& world, const Limits& limits, Rng& rng,
            const Observer& observer) {
    return run_in<StraightSpace>(planner, world, limits, rng, observer);
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

/// The problem as it is planned. A lone ASV has no broom that could collide, so that nothing
/// forbids it to cross obstacles; it goes round them as chains do where there is a way round, and
/// straight ahead where there is none.
Problem planned(Problem problem) {
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
    ChainSolver(const Problem& problem, const Planner& planner)
        : planner_(planner),
          unit_(unit_of(problem)),
          world_(in_units(planned(bounded(problem)), unit_), anchor_of(planner)) {}

    Attempt search(const Limits& limits, Rng& rng, const Observer& observer,
                   std::size_t racer) const override {
        const Observer in_units = [&](Progress progress) {
            progress.cost *= unit_;
            observer(progress);
        };
        const Observer& told = observer && unit_ != 1 ? in_units : observer;
        const Planner planner = varied(planner_, racer);
        return std::visit(
            [&](const auto& chosen) { return run(chosen, world_, limits, rng, told); }, planner);
    }

    double cost(const Configurations& path) const override {
        return unit_ * MotionCost(world_.chain).path(path);
    }

    Configurations improve(const Configurations& path, const ImprovementOrder& order, Rng& rng,
                           Attempt& spent) const override {
        const auto another = [&](Rng& draws) {
            Attempt attempt = search(order.search_limits, draws, {}, 0);
            spent.state_checks += attempt.state_checks;
            spent.edge_checks += attempt.edge_checks;
            return AnotherPath{
                std::move(attempt.search.path),
                work_of({attempt.state_checks, attempt.constrained_steps},
                        world_.problem.asv_count(), world_.problem.obstacles.size())};
        };
        const auto on_better = [&](double better) {
            if (order.on_better) order.on_better(unit_ * better);
        };
        MotionChecker checker = world_.make_checker();
        const auto* sliding = std::get_if<AutoPlanner>(&planner_);
        SlideSteering steering(checker, world_.metric,
                               sliding ? sliding->steering : SlideOptions{});
        Configurations rows =
            core::improve(path, checker, world_.metric, steering,
                          order.other_paths ? another : std::function<AnotherPath(Rng&)>{},
                          order.work, order.limits, rng, on_better);
        spent.state_checks += checker.state_checks();
        spent.edge_checks += checker.motion_checks();
        return rows;
    }

    Path steps(const Configurations& path) const override {
        MotionChecker checker = world_.make_checker();
        Path planned = primitive_steps(world_.problem, path, checker);
        if (unit_ != 1) planned = out_of_units(planned, unit_);
        if (!world_.transposed) return planned;
        Path result(planned.asv_count());
        result.reserve(planned.size());
        std::vector<Point> state;
        for (std::size_t i = 0; i < planned.size(); ++i) {
            state.assign(planned.state(i).begin(), planned.state(i).end());
            for (Point& p : state) std::swap(p.x, p.y);
            result.push_back(state);
        }
        return result;
    }

    std::vector<Point> places(const Tree& tree) const override {
        Pose pose = world_.chain.make_pose();
        std::vector<Point> points;
        for (std::uint32_t node = 0; node < tree.size(); ++node) {
            world_.chain.forward(tree.row(node), pose);
            const double x = unit_ * pose.x[0], y = unit_ * pose.y[0];
            points.push_back(world_.transposed ? Point{y, x} : Point{x, y});
        }
        return points;
    }

  private:
    const Planner& planner_;
    double unit_;  ///< of the world, in those of the problem
    ChainWorld world_;
};

}  // namespace

std::unique_ptr<BodySolver> make_chain_solver(const Problem& problem, const Planner& planner) {
    return std::make_unique<ChainSolver>(problem, planner);
}

}  // namespace asv::core
