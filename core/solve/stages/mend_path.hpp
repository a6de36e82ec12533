#pragma once

#include <optional>

#include "core/model/path.hpp"
#include "core/solve/stages/race.hpp"
#include "core/solve/stages/solve_call.hpp"

namespace asv::core {

/// The last path, in the coordinates of the given problem, made to fit the problem of the call, as
/// if the first thread had found it; none where that fails. Fills in the statistics of the search.
std::optional<RaceResult> mend_path(const SolveCall& call, const Path& last,
                                    SolveStatistics& statistics);

}  // namespace asv::core
