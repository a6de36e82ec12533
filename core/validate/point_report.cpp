#include "core/validate/point_report.hpp"

#include <array>
#include <optional>
#include <vector>

#include "core/validate/collisions.hpp"
#include "core/validate/path_checks.hpp"

namespace asv::core::validation {

namespace {

/// Adds up bounds and collisions, of states or of the straight motions between them.
class Places {
  public:
    Places(const Requirements& requirements, const Obstacles& obstacles, bool list)
        : requirements_(requirements),
          obstacles_(obstacles),
          bounds_(Check::bounds, list, BodyKind::point),
          collisions_(Check::collisions, list, BodyKind::point) {}

    /// The motion from one place to the other, which may be the same. The bounds are convex: what
    /// holds at both ends holds in between.
    void add(State from, State to, std::size_t index) {
        std::optional<Finding> bad = find_not_finite(from);
        if (!bad) bad = find_not_finite(to);
        if (bad) {
            bounds_.add(*bad, index);
            collisions_.add(*bad, index);
            return;
        }
        Finding inside = check_bounds(from, requirements_);
        keep_worse(inside, check_bounds(to, requirements_));
        bounds_.add(inside, index);
        const double reach = collisions_.worst().offender.room;
        collisions_.add(obstacles_.check_point({from[0], to[0]}, reach), index);
    }

    void finish(std::vector<CheckResult>& checks) && {
        checks.push_back(std::move(bounds_).result());
        checks.push_back(std::move(collisions_).result());
    }

  private:
    const Requirements& requirements_;
    const Obstacles& obstacles_;
    Tally bounds_, collisions_;
};

}  // namespace

ValidationReport report_point(const Problem& problem, const Solution& solution,
                              const Requirements& requirements, const ValidationOptions& options) {
    const Path& path = solution.path;
    const std::size_t last = path.size() - 1;
    const bool list = options.list_offenders;
    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    ValidationReport report;
    Tally ends(Check::ends, list, BodyKind::point), steps(Check::steps, list, BodyKind::point),
        cost(Check::cost, list, BodyKind::point);
    Places states(requirements, obstacles, list), motions(requirements, obstacles, list);
    ends.add(check_end(path.state(0), problem.start, requirements), 0);
    ends.add(check_end(path.state(last), problem.goal, requirements), last);
    states.add(path.state(0), path.state(0), 0);
    for (std::size_t i = 1; i <= last; ++i) {
        const State from = path.state(i - 1), to = path.state(i);
        steps.add(check_step(from, to, requirements), i);
        report.cost += step_cost(from, to);
        states.add(to, to, i);
        if (options.continuous) motions.add(from, to, i);
    }
    cost.add(check_cost(solution.cost, report.cost, requirements), 0);
    for (Tally* tally : {&ends, &steps, &cost}) report.checks.push_back(std::move(*tally).result());
    std::move(states).finish(report.checks);
    if (options.continuous) std::move(motions).finish(report.motion);
    return report;
}

ValidationReport report_point_state(const Problem& problem, State state,
                                    const Requirements& requirements,
                                    const ValidationOptions& options) {
    ValidationReport report;
    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    Places states(requirements, obstacles, options.list_offenders);
    states.add(state, state, 0);
    std::move(states).finish(report.checks);
    return report;
}

}  // namespace asv::core::validation
