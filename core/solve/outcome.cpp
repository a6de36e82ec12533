#include "core/bounds/feasibility.hpp"
#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"

/// What solve() tells of its result and of a problem that it refuses, in words.

namespace asv::core {

std::string_view name(SolveStatus status) {
    switch (status) {
        case SolveStatus::solved:
            return "solved";
        case SolveStatus::timeout:
            return "timeout";
        case SolveStatus::infeasible:
            return "infeasible";
        case SolveStatus::interrupted:
            return "interrupted";
    }
    return "unknown";
}

std::string_view name(TreeRoot root) {
    switch (root) {
        case TreeRoot::start:
            return "start";
        case TreeRoot::goal:
            return "goal";
        case TreeRoot::roadmap:
            return "roadmap";
    }
    return "unknown";
}

std::vector<InvalidEnd> invalid_ends(const Problem& problem) {
    std::vector<InvalidEnd> found;
    // Where no chain has the area, that of start and goal is not what is wrong.
    if (check_area(problem).cause != Infeasibility::none) return found;
    for (const bool goal : {false, true}) {
        const ValidationReport report =
            validate_state(problem, goal ? problem.goal : problem.start,
                           {.tolerance = problem.requirements.tolerance});
        for (const CheckResult& check : report.checks)
            if (!check.ok()) found.push_back({goal, describe(check)});
    }
    return found;
}

}  // namespace asv::core
