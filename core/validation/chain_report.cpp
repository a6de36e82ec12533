#include "core/validation/chain_report.hpp"

#include <optional>
#include <vector>

#include "core/validation/collisions.hpp"
#include "core/validation/motion/continuous.hpp"
#include "core/validation/path_tally.hpp"

namespace asv::core::validation {

namespace {

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
        const std::optional<Finding> bad = find_not_finite(state);
        const auto judged = [&](auto check) { return bad ? *bad : check(state, requirements_); };
        broom_lengths_.add(judged(check_broom_lengths), index);
        convexity_.add(judged(check_convexity), index);
        area_.add(judged(check_area), index);
        bounds_.add(judged(check_bounds), index);
        // Only what is tighter than all before is of interest, which keeps the search short.
        const double radius = collisions_.worst().offender.room;
        collisions_.add(bad ? *bad : obstacles_.check(state, radius), index);
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

}  // namespace

ValidationReport report_chain(const Problem& problem, const Solution& solution,
                              const Requirements& requirements, const ValidationOptions& options) {
    const Path& path = solution.path;
    ValidationReport report;
    check_path(problem, solution, requirements, options.list_offenders, report);
    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    StateChecks states(requirements, obstacles, options.list_offenders);
    for (std::size_t i = 0; i < path.size(); ++i) states.add(path.state(i), i);
    std::move(states).finish(report.checks);
    if (options.continuous)
        report.motion = certify_motion(path, requirements, obstacles, options.list_offenders);
    return report;
}

ValidationReport report_chain_state(const Problem& problem, State state,
                                    const Requirements& requirements,
                                    const ValidationOptions& options) {
    ValidationReport report;
    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    StateChecks states(requirements, obstacles, options.list_offenders);
    states.add(state, 0);
    std::move(states).finish(report.checks);
    return report;
}

}  // namespace asv::core::validation
