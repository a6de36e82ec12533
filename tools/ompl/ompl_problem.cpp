#include "tools/ompl/ompl_problem.hpp"

#include <utility>

#include "core/bounds/feasibility.hpp"
#include "core/model/cost.hpp"
#include "core/solve/planning_frame.hpp"
#include "core/solve/solve.hpp"
#include "tools/ompl/body.hpp"
#include "tools/ompl/body_checks.hpp"
#include "tools/ompl/body_space.hpp"

namespace asv::adaptor {

namespace {

const core::Problem& plannable(const core::Problem& problem) {
    if (auto invalid = core::invalid_ends(problem); !invalid.empty())
        throw core::InvalidEnds(std::move(invalid));
    for (const core::Feasibility& proof :
         {core::check_area(problem), core::check_orientation(problem)})
        if (proof.cause != core::Infeasibility::none) throw std::invalid_argument(proof.reason);
    return problem;
}

/// The configurations of a path one after the other, their angles unwrapped alike.
core::Configurations rows_of(const ompl::geometric::PathGeometric& path, const BodySpace& space) {
    core::Configurations rows;
    std::vector<double> row;
    for (unsigned int i = 0; i < path.getStateCount(); ++i) {
        const Row next = space.row(path.getState(i));
        row = unwrapped(next, i == 0 ? next : Row(row), space.body().wrapping());
        rows.insert(rows.end(), row.begin(), row.end());
    }
    return rows;
}

}  // namespace

OmplProblem::OmplProblem(const core::Problem& problem, MotionCheck motions)
    : problem_(plannable(problem)),
      frame_(std::make_shared<core::PlanningFrame>(problem_)),
      body_(make_body(frame_->problem())),
      information_(std::make_shared<ob::SpaceInformation>(std::make_shared<BodySpace>(body_))) {
    information_->setStateValidityChecker(std::make_shared<BodyValidity>(information_));
    if (motions == MotionCheck::certified)
        information_->setMotionValidator(std::make_shared<CertifiedMotions>(information_));
    information_->setup();
}

ob::ScopedState<> OmplProblem::state(bool goal) const {
    ob::ScopedState<> state(information_);
    body_space_of(*information_).assign(goal ? body_->goal() : body_->start(), state.get());
    return state;
}

ob::ScopedState<> OmplProblem::start() const {
    return state(false);
}

ob::ScopedState<> OmplProblem::goal() const {
    return state(true);
}

ob::OptimizationObjectivePtr OmplProblem::objective(Goodness goodness) const {
    return std::make_shared<BodyCost>(information_, goodness == Goodness::any_path);
}

ob::ProblemDefinitionPtr OmplProblem::definition(Goodness goodness) const {
    auto definition = std::make_shared<ob::ProblemDefinition>(information_);
    definition->setStartAndGoalStates(start(), goal());
    definition->setOptimizationObjective(objective(goodness));
    return definition;
}

std::optional<core::Solution> OmplProblem::solution(const ompl::geometric::PathGeometric& path,
                                                    core::Clock::time_point deadline) const {
    const auto steps = body_->steps(rows_of(path, body_space_of(*information_)), deadline);
    if (!steps) return std::nullopt;
    core::Solution solution{frame_->path_back(*steps), 0};
    solution.cost = core::cost(problem_, solution.path);
    return solution;
}

bool OmplProblem::certified(const ompl::geometric::PathGeometric& path) const {
    const CertifiedMotions proof(information_);
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        if (!proof.checkMotion(path.getState(i - 1), path.getState(i))) return false;
    return true;
}

}  // namespace asv::adaptor
