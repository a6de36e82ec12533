#include "core/validate/validate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/validate/arm/arm_report.hpp"
#include "core/validate/collisions.hpp"
#include "core/validate/motion/continuous.hpp"
#include "core/validate/path_checks.hpp"
#include "core/validate/point_report.hpp"
#include "core/validate/state_checks.hpp"

namespace asv::core {
namespace {

using validation::Finding;
using validation::Obstacles;
using validation::State;
using validation::Tally;

/// Adds up the five checks that concern each state alone.
class StateChecks {
  public:
    StateChecks(const Requirements& requirements, const Obstacles& obstacles, bool list)
        : requirements_(requirements),
          obstacles_(obstacles),
          broom_lengths_(Check::broom_lengths, list),
          convexity_(Check::convexity, list),
          area_(Check::area, list),
          bounds_(Check::bounds, list),
          collisions_(Check::collisions, list) {}

    void add(State state, std::size_t index) {
        const std::optional<Finding> bad = validation::find_not_finite(state);
        const auto judged = [&](auto check) { return bad ? *bad : check(state, requirements_); };
        broom_lengths_.add(judged(validation::check_broom_lengths), index);
        convexity_.add(judged(validation::check_convexity), index);
        area_.add(judged(validation::check_area), index);
        bounds_.add(judged(validation::check_bounds), index);
        // Only what is tighter than all before is of interest, which keeps the search short.
        const double reach = collisions_.worst().offender.room;
        collisions_.add(bad ? *bad : obstacles_.check(state, reach), index);
    }

    void finish(std::vector<CheckResult>& checks) && {
        for (Tally* tally : {&broom_lengths_, &convexity_, &area_, &bounds_, &collisions_}) {
            checks.push_back(std::move(*tally).result());
        }
    }

  private:
    const Requirements& requirements_;
    const Obstacles& obstacles_;
    Tally broom_lengths_;
    Tally convexity_;
    Tally area_;
    Tally bounds_;
    Tally collisions_;
};

/// Adds up the three checks that concern the path as a whole; the cost of the path is returned.
double check_path(const Problem& problem, const Solution& solution,
                  const Requirements& requirements, bool list, std::vector<CheckResult>& checks) {
    const Path& path = solution.path;
    const std::size_t last = path.size() - 1;
    Tally ends(Check::ends, list);
    ends.add(validation::check_end(path.state(0), problem.start, requirements), 0);
    ends.add(validation::check_end(path.state(last), problem.goal, requirements), last);
    Tally steps(Check::steps, list);
    double total = 0;
    for (std::size_t i = 1; i <= last; ++i) {
        steps.add(validation::check_step(path.state(i - 1), path.state(i), requirements), i);
        total += validation::step_cost(path.state(i - 1), path.state(i));
    }
    Tally cost(Check::cost, list);
    cost.add(validation::check_cost(solution.cost, total, requirements), 0);
    for (Tally* tally : {&ends, &steps, &cost}) checks.push_back(std::move(*tally).result());
    return total;
}

Requirements with_tolerance(const Problem& problem, double tolerance) {
    if (!(tolerance >= 0 && std::isfinite(tolerance))) {
        throw std::invalid_argument("validate: the tolerance is negative or not finite");
    }
    Requirements requirements = problem.requirements;
    requirements.tolerance = tolerance;
    return requirements;
}

}  // namespace

bool ValidationReport::valid() const {
    const auto holds = [](const CheckResult& result) { return result.ok(); };
    return std::all_of(checks.begin(), checks.end(), holds) &&
           std::all_of(motion.begin(), motion.end(), holds);
}

ValidationReport validate(const Problem& problem, const Solution& solution,
                          const ValidationOptions& options) {
    const Path& path = solution.path;
    if (path.empty()) throw std::invalid_argument("validate: the path is empty");
    if (path.asv_count() != problem.asv_count()) {
        throw std::invalid_argument("validate: path and problem differ in their number of ASVs");
    }
    const Requirements requirements = with_tolerance(problem, options.tolerance);
    if (const PlanarArm* arm = problem.arm())
        return validation::report_arm(problem, *arm, solution, requirements, options);
    if (problem.body_kind() == BodyKind::point)
        return validation::report_point(problem, solution, requirements, options);
    ValidationReport report;
    report.cost =
        check_path(problem, solution, requirements, options.list_offenders, report.checks);
    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    StateChecks states(requirements, obstacles, options.list_offenders);
    for (std::size_t i = 0; i < path.size(); ++i) states.add(path.state(i), i);
    std::move(states).finish(report.checks);
    if (options.continuous) {
        report.motion =
            validation::certify_motion(path, requirements, obstacles, options.list_offenders);
    }
    return report;
}

ValidationReport validate_state(const Problem& problem, std::span<const geometry::Point> state,
                                const ValidationOptions& options) {
    if (state.empty()) throw std::invalid_argument("validate_state: the state has no ASV");
    const Requirements requirements = with_tolerance(problem, options.tolerance);
    if (const PlanarArm* arm = problem.arm())
        return validation::report_arm_state(problem, *arm, state, requirements, options);
    if (problem.body_kind() == BodyKind::point)
        return validation::report_point_state(problem, state, requirements, options);
    ValidationReport report;
    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    StateChecks states(requirements, obstacles, options.list_offenders);
    states.add(state, 0);
    std::move(states).finish(report.checks);
    return report;
}

}  // namespace asv::core
