#pragma once

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/validation/report.hpp"
#include "core/validation/state_checks.hpp"
#include "core/validation/validation_options.hpp"

namespace asv::core::validation {

/// The checks of validate() on a point: ends, steps, cost, bounds, collisions; along the motion,
/// which is straight, bounds and collisions.
/// requirements: those of the problem with the tolerance that counts.
ValidationReport report_point(const Problem& problem, const Solution& solution,
                              const Requirements& requirements, const ValidationOptions& options);

/// Those of validate_state(): bounds, collisions.
ValidationReport report_point_state(const Problem& problem, State state,
                                    const Requirements& requirements,
                                    const ValidationOptions& options);

}  // namespace asv::core::validation
