#pragma once

#include <optional>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/solve/solve_result.hpp"
#include "tools/mpi/solve/race_bytes.hpp"

/// What a race comes to, once its ranks have ended. The finish of each is given, by rank; there is
/// none of one that was not waited for.

namespace asv::tools {

using Finishes = std::vector<std::optional<RaceFinish>>;

/// Has one proven that its path cannot be improved or that there is none, has one failed, or does
/// the best cost of all meet the bound of one?
bool is_decided(const Finishes& finishes, double best_cost);

/// The rank with the least cost, the first of several; none where no rank has a path.
std::optional<int> best_rank(const Finishes& finishes);

/// Makes the path of another rank the solution. Throws std::logic_error where the validator rejects
/// it (a bug).
void take_solution(const core::Problem& problem, core::Path path, const RaceFinish& finish,
                   core::SolveResult& result);

/// Where a rank has proven that there is no path, so has the race.
void take_proof(const Finishes& finishes, core::SolveResult& result);

/// What all ranks have checked, and the best bounds of any.
void take_statistics(const Finishes& finishes, core::SolveResult& result);

/// Throws std::runtime_error where a rank has failed.
void require_no_failure(const Finishes& finishes);

}  // namespace asv::tools
