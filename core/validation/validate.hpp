#pragma once

#include <span>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/validation/report.hpp"
#include "core/validation/validation_options.hpp"

/// The independent checker: every requirement of the assignment, decided with exact predicates and
/// without any code of the planner.

namespace asv::core {

/// Checks a whole solution. Throws std::invalid_argument when the path is empty or its number of
/// ASVs is not the problem's, or when the tolerance is negative or not finite. A coordinate that
/// is not finite fails every check of its state. O(states * (n + log m)) for m obstacles that
/// overlap little.
ValidationReport validate(const Problem& problem, const Solution& solution,
                          const ValidationOptions& options = {});

/// Checks one state alone (what is left of the checks without ends, steps and cost): starts and
/// goals.
ValidationReport validate_state(const Problem& problem, std::span<const geometry::Point> state,
                                const ValidationOptions& options = {});

}  // namespace asv::core
