#include "tools/families/solvability.hpp"

#include <limits>
#include <string>

#include "core/bounds/feasibility.hpp"
#include "core/generate/vouch/vouch.hpp"
#include "core/solve/solve.hpp"

namespace asv::tools {

namespace {

/// The hardest problems of the field take some hundreds.
constexpr std::size_t planner_iterations = 3000;

}  // namespace

std::string name(Solvability::Verdict verdict) {
    switch (verdict) {
        case Solvability::Verdict::solvable:
            return "solvable";
        case Solvability::Verdict::infeasible:
            return "infeasible";
        case Solvability::Verdict::unknown:
            break;
    }
    return "unknown";
}

Solvability solvability(const core::Problem& problem, std::uint64_t seed) {
    using Verdict = Solvability::Verdict;
    const core::Verdict vouched = core::vouch(problem);
    if (vouched.solvable) return {Verdict::solvable, vouched.reason};
    const core::Feasibility found = core::check_feasibility(problem);
    if (found.proven_infeasible()) return {Verdict::infeasible, found.reason};
    core::SolveOptions options;
    options.seed = seed;
    options.optimize = 0;
    options.max_iterations = planner_iterations;
    options.time_limit = std::numeric_limits<double>::max();
    const core::SolveResult result = core::solve(problem, options);
    if (result.solution)
        return {Verdict::solvable, "the planner finds a path, which the validator passes"};
    // The planner looks for this proof as well, but for a while that depends on the machine.
    const core::Feasibility no_room = core::check_passages(problem);
    if (no_room.proven_infeasible()) return {Verdict::infeasible, no_room.reason};
    if (found.cause != core::Infeasibility::none) return {Verdict::unknown, found.reason};
    return {Verdict::unknown, vouched.reason + "; the planner finds no path in " +
                                  std::to_string(planner_iterations) + " iterations"};
}

}  // namespace asv::tools
