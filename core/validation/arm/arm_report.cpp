#include "core/validation/arm/arm_report.hpp"

#include <optional>
#include <vector>

#include "core/validation/arm/arm_checks.hpp"
#include "core/validation/arm/arm_motion.hpp"
#include "core/validation/collisions.hpp"
#include "core/validation/path_checks.hpp"
#include "core/validation/path_tally.hpp"

namespace asv::core::validation {

namespace {

constexpr BodyKind kind = BodyKind::arm;

/// Adds up the checks that concern each state alone.
class ArmStates {
  public:
    ArmStates(const Problem& problem, const PlanarArm& arm, const Requirements& requirements,
              const Obstacles& obstacles, bool list)
        : problem_(problem),
          arm_(arm),
          requirements_(requirements),
          obstacles_(obstacles),
          lengths_(Check::link_lengths, list, kind),
          base_(Check::base, list, kind),
          limits_(Check::joint_limits, list, kind),
          bounds_(Check::bounds, list, kind),
          collisions_(Check::collisions, list, kind) {}

    void add(State state, std::span<const double> angles, std::size_t index) {
        if (const std::optional<Finding> bad = find_not_finite(state)) {
            for (Tally* tally : tallies()) tally->add(*bad, index);
            return;
        }
        lengths_.add(check_link_lengths(state, arm_, requirements_), index);
        base_.add(check_base(state, problem_.start[0], requirements_), index);
        limits_.add(check_joint_limits(angles, arm_, requirements_), index);
        bounds_.add(check_bounds(state, requirements_), index);
        // Only what is tighter than all before is of interest, which keeps the search short.
        collisions_.add(obstacles_.check(state, collisions_.worst().offender.room), index);
    }

    void finish(std::vector<CheckResult>& checks) && {
        for (Tally* tally : tallies()) checks.push_back(std::move(*tally).result());
    }

  private:
    std::vector<Tally*> tallies() { return {&lengths_, &base_, &limits_, &bounds_, &collisions_}; }

    const Problem& problem_;
    const PlanarArm& arm_;
    const Requirements& requirements_;
    const Obstacles& obstacles_;
    Tally lengths_, base_, limits_, bounds_, collisions_;
};

std::vector<std::vector<double>> read_angles(const Path& path, const PlanarArm& arm) {
    JointReader reader(arm, arm.start);
    std::vector<std::vector<double>> angles;
    angles.reserve(path.size());
    for (std::size_t i = 0; i < path.size(); ++i) angles.push_back(reader.read(path.state(i)));
    return angles;
}

/// The heading of each link, where headings of neighbouring states belong together.
std::vector<double> headings(const PlanarArm& arm, const std::vector<double>& angles) {
    std::vector<double> result = angles;
    if (arm.angles == AngleReference::previous_link)
        for (std::size_t i = 1; i < result.size(); ++i) result[i] += result[i - 1];
    return result;
}

std::vector<CheckResult> certify(const Path& path, const Problem& problem, const PlanarArm& arm,
                                 const std::vector<std::vector<double>>& angles,
                                 const Requirements& requirements, const Obstacles& obstacles,
                                 bool list) {
    Tally bounds(Check::bounds, list, kind), collisions(Check::collisions, list, kind);
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (const std::optional<Finding> bad = find_not_finite(path.state(i - 1), path.state(i))) {
            bounds.add(*bad, i);
            collisions.add(*bad, i);
            continue;
        }
        const ArmMotion motion(arm.links, problem.start[0], headings(arm, angles[i - 1]),
                               headings(arm, angles[i]));
        bounds.add(check_arm_motion_bounds(motion, requirements), i);
        const double radius = collisions.worst().offender.room;
        collisions.add(check_arm_motion_collisions(motion, obstacles, radius), i);
    }
    std::vector<CheckResult> results;
    results.push_back(std::move(bounds).result());
    results.push_back(std::move(collisions).result());
    return results;
}

}  // namespace

ValidationReport report_arm(const Problem& problem, const PlanarArm& arm, const Solution& solution,
                            const Requirements& requirements, const ValidationOptions& options) {
    const Path& path = solution.path;
    const std::size_t last = path.size() - 1;
    const bool list = options.list_offenders;
    const auto angles = read_angles(path, arm);
    ValidationReport report;

    PathTally tally(requirements, list, kind);
    tally.add_end(check_end(path.state(0), problem.start, requirements), 0);
    Finding end = check_end(path.state(last), problem.goal, requirements);
    keep_worse(end, check_turns(angles[last], arm.goal, arm));
    tally.add_end(end, last);
    for (std::size_t i = 1; i <= last; ++i)
        tally.add_step(path.state(i - 1), path.state(i), joint_distance(angles[i - 1], angles[i]),
                       i);
    std::move(tally).finish(solution.cost, report);

    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    ArmStates states(problem, arm, requirements, obstacles, list);
    for (std::size_t i = 0; i <= last; ++i) states.add(path.state(i), angles[i], i);
    std::move(states).finish(report.checks);
    if (options.continuous)
        report.motion = certify(path, problem, arm, angles, requirements, obstacles, list);
    return report;
}

ValidationReport report_arm_state(const Problem& problem, const PlanarArm& arm, State state,
                                  const Requirements& requirements,
                                  const ValidationOptions& options) {
    ValidationReport report;
    const Obstacles obstacles(problem.obstacles, requirements.tolerance);
    ArmStates states(problem, arm, requirements, obstacles, options.list_offenders);
    JointReader reader(arm, middle_of_ranges(arm));
    states.add(state, reader.read(state), 0);
    std::move(states).finish(report.checks);
    return report;
}

}  // namespace asv::core::validation
