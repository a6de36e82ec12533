#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "tools/ompl/body_space.hpp"

/// What OMPL asks of a BodySpace: which states and motions are valid, and what motions cost.

namespace asv::adaptor {

/// The BodySpace of the information. Throws std::invalid_argument where it has another one.
const BodySpace& body_space_of(const ob::SpaceInformation& information);

class BodyValidity : public ob::StateValidityChecker {
  public:
    explicit BodyValidity(const ob::SpaceInformationPtr& information);
    bool isValid(const ob::State* state) const override;

  private:
    const BodySpace& space_;
};

/// Proves motions whole (core/space/proof/motion_checker.hpp), where OMPL's own
/// DiscreteMotionValidator looks at samples of them. The first state counts as valid.
class CertifiedMotions : public ob::MotionValidator {
  public:
    explicit CertifiedMotions(const ob::SpaceInformationPtr& information);
    bool checkMotion(const ob::State* from, const ob::State* to) const override;
    bool checkMotion(const ob::State* from, const ob::State* to,
                     std::pair<ob::State*, double>& last_valid) const override;

  private:
    const BodySpace& space_;
};

/// The cost of a path as the validator has it, in units of planning coordinates: the distance that
/// all ASVs move, the way in joint angles, or the way of the point.
class BodyCost : public ob::OptimizationObjective {
  public:
    /// Until satisfied: with any_path the first path is good enough, else no path ever is.
    BodyCost(const ob::SpaceInformationPtr& information, bool any_path);
    ob::Cost stateCost(const ob::State* state) const override;
    ob::Cost motionCost(const ob::State* from, const ob::State* to) const override;
    ob::Cost motionCostHeuristic(const ob::State* from, const ob::State* to) const override;

  private:
    const BodySpace& space_;
};

}  // namespace asv::adaptor
