#pragma once

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/validation/report.hpp"
#include "core/validation/state_checks.hpp"
#include "core/validation/validation_options.hpp"

namespace asv::core::validation {

/// The checks of validate() on an arm: ends, steps, cost, link lengths, base, joint limits, bounds,
/// collisions; along the motion, where each joint turns evenly the short way, bounds and
/// collisions (lengths and base stay, and joint limits hold where they hold at both ends).
/// requirements: those of the problem with the tolerance that counts.
ValidationReport report_arm(const Problem& problem, const PlanarArm& arm, const Solution& solution,
                            const Requirements& requirements, const ValidationOptions& options);

/// Those of validate_state(): link lengths, base, joint limits, bounds, collisions.
ValidationReport report_arm_state(const Problem& problem, const PlanarArm& arm, State state,
                                  const Requirements& requirements,
                                  const ValidationOptions& options);

}  // namespace asv::core::validation
