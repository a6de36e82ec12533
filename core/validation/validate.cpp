#include "core/validation/validate.hpp"

#include <cmath>
#include <stdexcept>

#include "core/validation/arm/arm_report.hpp"
#include "core/validation/chain_report.hpp"
#include "core/validation/point_report.hpp"

namespace asv::core {
namespace {

Requirements with_tolerance(const Problem& problem, double tolerance) {
    if (!(tolerance >= 0 && std::isfinite(tolerance))) {
        throw std::invalid_argument("validate: the tolerance is negative or not finite");
    }
    Requirements requirements = problem.requirements;
    requirements.tolerance = tolerance;
    return requirements;
}

}  // namespace

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
    return validation::report_chain(problem, solution, requirements, options);
}

ValidationReport validate_state(const Problem& problem, std::span<const geometry::Point> state,
                                const ValidationOptions& options) {
    if (state.empty()) throw std::invalid_argument("validate_state: the state has no ASV");
    const Requirements requirements = with_tolerance(problem, options.tolerance);
    if (const PlanarArm* arm = problem.arm())
        return validation::report_arm_state(problem, *arm, state, requirements, options);
    if (problem.body_kind() == BodyKind::point)
        return validation::report_point_state(problem, state, requirements, options);
    return validation::report_chain_state(problem, state, requirements, options);
}

}  // namespace asv::core
