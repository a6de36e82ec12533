#pragma once

#include <ompl/base/Planner.h>

namespace asv::adaptor {

/// The library's default planner, `auto`, as one of OMPL: slides and pulls between two trees, then
/// shortens the path and looks for other ones. Its paths have proven motions alone.
///
/// Start and goal are those of the problem definition, one state each; obstacles and requirements
/// are those of the space's OmplProblem. An objective is not asked for: it shortens what the
/// validator calls the cost. Random draws follow OMPL's seed.
class AsvPlanner : public ompl::base::Planner {
  public:
    /// Throws std::invalid_argument where the state space is not that of an OmplProblem.
    explicit AsvPlanner(const ompl::base::SpaceInformationPtr& information);

    /// Improvement after the first path: seconds of work of a 2.8 GHz core, 0 or more, counted and
    /// not timed. Parameter "optimize".
    void set_optimize(double seconds) { optimize_ = seconds; }
    double optimize() const { return optimize_; }

    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& end) override;

  private:
    double optimize_ = 1;
};

}  // namespace asv::adaptor
