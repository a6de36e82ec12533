#pragma once

#include "core/validation/state_checks.hpp"

/// The requirements on a path as a whole.

namespace asv::core::validation {

/// No ASV is farther than limit from its counterpart. Room: length.
Finding check_distances(State from, State to, double limit);

/// Every ASV is within the tolerance of where it should be. Room: length.
Finding check_end(State state, State wanted, const Requirements& requirements);

/// No ASV moves farther than the longest step. Room: length.
Finding check_step(State from, State to, const Requirements& requirements);

/// The distance that all ASVs together move from one state to the next.
double step_cost(State from, State to);

/// The written cost is within the tolerance of the computed one, or within the rounding of that: no
/// tolerance asks for more digits than a sum has. Room: length.
Finding check_cost(double written, double computed, double rounding,
                   const Requirements& requirements);

}  // namespace asv::core::validation
