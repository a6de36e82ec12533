#pragma once

#include <memory>
#include <optional>
#include <stdexcept>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/search/limits.hpp"

/// The door to OMPL: a problem goes in, what OMPL's planners ask for comes out, and their paths
/// become primitive steps.

namespace asv::core {
class PlanningFrame;
}

namespace asv::adaptor {

class Body;

/// How OMPL is told whether a motion is valid.
enum class MotionCheck {
    certified,  ///< all of it is proven, as for the library's own planners
    sampled     ///< by OMPL's DiscreteMotionValidator, which misses what lies between its samples
};

/// When a planner that improves its path is content.
enum class Goodness {
    any_path,  ///< with its first path
    best_path  ///< never: it goes on until it is told to end
};

/// A problem of a chain, an arm or a point for OMPL's planners. A state is a
/// RealVectorStateSpace::StateType with the configuration in planning coordinates: of a chain the
/// centroid, the mean heading in [-pi, pi), and the turns, radians; of an arm its joint angles,
/// those that wrap first and in [0, 2 pi); of a point x and y.
class OmplProblem {
  public:
    /// Throws std::invalid_argument when the start or the goal is not valid (core::InvalidEnds), or
    /// when both turn in opposite directions, which no path changes.
    explicit OmplProblem(const core::Problem& problem,
                         MotionCheck motions = MotionCheck::certified);

    /// With state space, sampler, validity checker and motion validator, set up.
    const ompl::base::SpaceInformationPtr& space_information() const { return information_; }
    ompl::base::ScopedState<> start() const;
    ompl::base::ScopedState<> goal() const;
    /// The cost of motions as the validator has it, up to the unit of planning coordinates. OMPL's
    /// informed samplers need it: they know nothing of the metric of a body.
    ompl::base::OptimizationObjectivePtr objective(Goodness goodness) const;
    /// Start, goal and objective.
    ompl::base::ProblemDefinitionPtr definition(Goodness goodness) const;

    /// A path of OMPL from the start to the goal in primitive steps, in the coordinates of the
    /// given problem; none when the deadline comes first. It is what core::validate() accepts where
    /// all motions of the path are certified; who plans with sampled motions has to ask it.
    std::optional<core::Solution> solution(
        const ompl::geometric::PathGeometric& path,
        core::Clock::time_point deadline = core::Clock::time_point::max()) const;
    /// Is every motion of the path proven valid, whatever check it was planned with?
    bool certified(const ompl::geometric::PathGeometric& path) const;

  private:
    ompl::base::ScopedState<> state(bool goal) const;

    core::Problem problem_;
    std::shared_ptr<const core::PlanningFrame> frame_;
    std::shared_ptr<const Body> body_;
    ompl::base::SpaceInformationPtr information_;
};

}  // namespace asv::adaptor
