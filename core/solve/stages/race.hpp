#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/search/search_result.hpp"
#include "core/solve/stages/solve_call.hpp"

namespace asv::core {

/// What the race for the first path came to: a path, a proof that there is none, or neither.
struct RaceResult {
    std::optional<std::size_t> winner;      ///< the thread that found the path
    bool mended = false;                    ///< the path is an earlier one that was mended
    Configurations path;                    ///< in planning coordinates
    std::optional<std::string> infeasible;  ///< why there is none
    Outcome failure = Outcome::deadline;    ///< why the first thread gave up
};

/// All threads search; the first path stops the others. Beside a search that turns out not to be
/// easy, a proof that it is in vain is looked for. Fills in what the result says of the search:
/// its statistics, trees and edges.
RaceResult race_for_first_path(const SolveCall& call, SolveResult& result);

}  // namespace asv::core
