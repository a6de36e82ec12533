#include "tools/ompl/asv_planner.hpp"

#include <chrono>
#include <stop_token>
#include <thread>

#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>

#include "core/solve/bodies/body_solver.hpp"
#include "core/solve/solve.hpp"
#include "tools/ompl/body_checks.hpp"
#include "tools/ompl/body_space.hpp"

namespace asv::adaptor {

namespace {

/// Asks OMPL over and over whether to end, while it lives, and passes that on as a stop.
class EndWatch {
  public:
    explicit EndWatch(const ob::PlannerTerminationCondition& end)
        : thread_([this, &end](const std::stop_token& over) {
              constexpr std::chrono::milliseconds pause(1);
              while (!over.stop_requested() && !end) std::this_thread::sleep_for(pause);
              ended_.request_stop();
          }) {}

    std::stop_token token() const { return ended_.get_token(); }

  private:
    std::stop_source ended_;
    std::jthread thread_;
};

/// Search and improvement as solve() has them, in one thread; empty when it has to end before.
core::Configurations plan(const core::Problem& problem, const core::Limits& limits, core::Rng& rng,
                          double optimize) {
    const core::Planner planner = core::AutoPlanner{};
    const auto solver = core::make_body_solver(problem, planner);
    const core::Attempt found = solver->search(limits, rng, {}, 0);
    if (found.search.path.empty()) return {};
    constexpr double microseconds_per_second = 1e6;
    core::ImprovementOrder order;
    order.work = optimize * microseconds_per_second;
    order.other_paths = optimize > 0;
    order.limits = order.search_limits = limits;
    return solver->improve(found.search.path, order, rng).path;
}

}  // namespace

AsvPlanner::AsvPlanner(const ob::SpaceInformationPtr& information)
    : ob::Planner(information, "AsvAuto") {
    body_space_of(*information);
    specs_.optimizingPaths = true;
    declareParam<double>("optimize", this, &AsvPlanner::set_optimize, &AsvPlanner::optimize,
                         "0.:0.1:60.");
}

ob::PlannerStatus AsvPlanner::solve(const ob::PlannerTerminationCondition& end) {
    checkValidity();
    const ob::State* start = pis_.nextStart();
    if (!start) return ob::PlannerStatus::INVALID_START;
    const ob::State* goal = pis_.nextGoal(end);
    if (!goal) return ob::PlannerStatus::INVALID_GOAL;

    const BodySpace& space = body_space_of(*si_);
    const core::Problem problem = space.body().problem_between(space.row(start), space.row(goal));
    if (!core::invalid_ends(problem).empty()) return ob::PlannerStatus::INVALID_START;

    const EndWatch watch(end);
    core::Limits limits;
    limits.stop = watch.token();
    core::Rng rng(ompl::RNG().getLocalSeed());
    const core::Configurations rows = plan(problem, limits, rng, optimize_);
    if (rows.empty()) return ob::PlannerStatus::TIMEOUT;

    auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
    const std::size_t dimension = space.getDimension();
    ob::ScopedState<> way_point(si_);
    path->append(start);
    for (std::size_t i = dimension; i + dimension < rows.size(); i += dimension) {
        space.assign({rows.data() + i, dimension}, way_point.get());
        path->append(way_point.get());
    }
    path->append(goal);
    pdef_->addSolutionPath(path, false, 0.0, getName());
    return ob::PlannerStatus::EXACT_SOLUTION;
}

}  // namespace asv::adaptor
