#pragma once

#include "core/model/path.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// How many of the problem's units make one of those in which brooms are 0.05 long, about: a power
/// of two, so that no number changes but for its exponent; 1 for brooms of 0.05. The planner's
/// lengths (margins, steps) are made for that unit.
double unit_of(const Problem& problem);

/// The problem of a chain in units that are `unit` long; its tolerance stays one of length.
Problem in_units(Problem problem, double unit);

/// A path of that problem in the units of the given one, with its ends.
Path out_of_units(const Path& path, double unit);

}  // namespace asv::core
