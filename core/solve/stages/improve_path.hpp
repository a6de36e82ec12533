#pragma once

#include "core/solve/stages/race.hpp"
#include "core/solve/stages/solve_call.hpp"

namespace asv::core {

/// Every thread improves the first path with draws of its own; the best path is returned, in
/// planning coordinates. Adds to the statistics what that took and the costs that it came to.
Configurations improve_path(const SolveCall& call, const RaceResult& first,
                            SolveStatistics& statistics);

}  // namespace asv::core
