#pragma once

#include "core/solve/stages/solve_call.hpp"

namespace asv::core {

/// Notes in the statistics what any path costs at least, and how many steps it has, as well as that
/// can be told in the time that is left, less a reserve in seconds.
void find_bounds(const SolveCall& call, double reserve, SolveStatistics& statistics);

}  // namespace asv::core
