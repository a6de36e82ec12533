#pragma once

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/validation/report.hpp"
#include "core/validation/state_checks.hpp"
#include "core/validation/validation_options.hpp"

namespace asv::core::validation {

/// The checks of validate() on a chain of ASVs: ends, steps, cost, broom lengths, convexity, area,
/// bounds, collisions; the last five along the motion as well, where that is asked for.
/// requirements: those of the problem with the tolerance that counts.
ValidationReport report_chain(const Problem& problem, const Solution& solution,
                              const Requirements& requirements, const ValidationOptions& options);

/// Those of validate_state(): broom lengths, convexity, area, bounds, collisions.
ValidationReport report_chain_state(const Problem& problem, State state,
                                    const Requirements& requirements,
                                    const ValidationOptions& options);

}  // namespace asv::core::validation
