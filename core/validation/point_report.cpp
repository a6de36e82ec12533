#include "core/validation/point_report.hpp"

#include <optional>
#include <vector>

#include "core/validation/collisions.hpp"
#include "core/validation/path_tally.hpp"

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
        if (const std::optional<Finding> bad = find_not_finite(from, to)) {
            bounds_.add(*bad, index);
            collisions_.add(*bad, index);
            return;
        }
        Finding inside = check_bounds(from, requirements_);
        keep_worse(inside, check_bounds(to, requirements_));
        bounds_.add(inside, index);
        const double radius = collisions_.worst().offender.room;
        collisions_.add(obstacles_.check_point({from[0], to[0]}, radius), index);
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
    ValidationReport report;
    check_path(problem, solution, requirements, options.list_offenders, report);
    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    Places states(requirements, obstacles, options.list_offenders);
    for (std::size_t i = 0; i < path.size(); ++i) states.add(path.state(i), path.state(i), i);
    std::move(states).finish(report.checks);
    if (!options.continuous) return report;
    Places motions(requirements, obstacles, options.list_offenders);
    for (std::size_t i = 1; i < path.size(); ++i) motions.add(path.state(i - 1), path.state(i), i);
    std::move(motions).finish(report.motion);
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
