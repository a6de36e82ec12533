#include "core/bounds/feasibility.hpp"
#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"

namespace asv::core {

InvalidEnds::InvalidEnds(std::vector<InvalidEnd> ends)
    : std::invalid_argument(std::string(ends.front().goal ? "goal" : "start") +
                            " is not valid: " + ends.front().reason),
      ends_(std::move(ends)) {}

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
