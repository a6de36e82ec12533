#include "tools/ompl/body_checks.hpp"

#include <algorithm>
#include <stdexcept>

#include <ompl/base/goals/GoalState.h>

namespace asv::adaptor {

const BodySpace& body_space_of(const ob::SpaceInformation& information) {
    const auto* space = dynamic_cast<const BodySpace*>(information.getStateSpace().get());
    if (!space) throw std::invalid_argument("the state space is not that of an OmplProblem");
    return *space;
}

BodyValidity::BodyValidity(const ob::SpaceInformationPtr& information)
    : ob::StateValidityChecker(information), space_(body_space_of(*information)) {}

bool BodyValidity::isValid(const ob::State* state) const {
    return space_.body().valid(space_.row(state));
}

CertifiedMotions::CertifiedMotions(const ob::SpaceInformationPtr& information)
    : ob::MotionValidator(information), space_(body_space_of(*information)) {}

bool CertifiedMotions::checkMotion(const ob::State* from, const ob::State* to) const {
    const bool proven = space_.body().motion_valid(space_.row(from), space_.row(to));
    ++(proven ? valid_ : invalid_);
    return proven;
}

bool CertifiedMotions::checkMotion(const ob::State* from, const ob::State* to,
                                   std::pair<ob::State*, double>& last_valid) const {
    if (checkMotion(from, to)) return true;
    const Row begin = space_.row(from);
    const std::vector<double> end = space_.body().proven_end(begin, space_.row(to));
    const double whole = space_.distance(from, to);
    // The proof of a part may come out where that of the whole does not; it is a part all the same.
    last_valid.second = whole > 0 ? std::min(space_.body().distance(begin, end) / whole, 1.0) : 0.0;
    if (last_valid.first != nullptr) space_.assign(end, last_valid.first);
    return false;
}

BodyCost::BodyCost(const ob::SpaceInformationPtr& information, bool any_path)
    : ob::OptimizationObjective(information), space_(body_space_of(*information)) {
    description_ = "cost of the body's motion";
    if (any_path) setCostThreshold(infiniteCost());
    setCostToGoHeuristic([this](const ob::State* state, const ob::Goal* goal) {
        const auto* goal_state = dynamic_cast<const ob::GoalState*>(goal);
        return goal_state ? motionCostHeuristic(state, goal_state->getState()) : identityCost();
    });
}

ob::Cost BodyCost::stateCost(const ob::State*) const {
    return identityCost();
}

ob::Cost BodyCost::motionCost(const ob::State* from, const ob::State* to) const {
    return ob::Cost(space_.body().cost(space_.row(from), space_.row(to)));
}

ob::Cost BodyCost::motionCostHeuristic(const ob::State* from, const ob::State* to) const {
    return ob::Cost(space_.body().cost_lower_bound(space_.row(from), space_.row(to)));
}

}  // namespace asv::adaptor
