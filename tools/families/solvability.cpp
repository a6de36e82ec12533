#include "tools/families/solvability.hpp"

#include <limits>
#include <string>

#include "core/solve/solve.hpp"

namespace asv::tools {

namespace {

/// The hardest problems of the field take some hundreds.
constexpr std::size_t planner_iterations = 3000;

}  // namespace

core::Verdict solvability(const core::Problem& problem, std::uint64_t seed) {
    core::Verdict verdict = core::vouch(problem);
    if (verdict.solvable) return verdict;
    core::SolveOptions options;
    options.seed = seed;
    options.optimize = 0;
    options.max_iterations = planner_iterations;
    options.time_limit = std::numeric_limits<double>::max();
    const core::SolveResult result = core::solve(problem, options);
    if (result.solution) {
        verdict.solvable = true;
        verdict.reason = "the planner finds a path, which the validator passes";
    } else if (result.status == core::SolveStatus::infeasible) {
        verdict.reason = result.reason;
    } else {
        verdict.reason +=
            "; the planner finds no path in " + std::to_string(planner_iterations) + " iterations";
    }
    return verdict;
}

}  // namespace asv::tools
