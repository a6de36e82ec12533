#include "core/solve/solve.hpp"

#include <optional>
#include <stdexcept>
#include <string>

#include "core/validation/validate.hpp"
#include "io/problem/scenario_file.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/small_case.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

namespace {

/// The result; none where ends or settings are refused.
std::optional<core::SolveResult> solved(const core::Problem& problem,
                                        const core::SolveOptions& options) {
    try {
        core::require_usable(options.planner, problem.body_kind());
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
    try {
        return core::solve(problem, options);
    } catch (const core::InvalidEnds&) {
        return std::nullopt;
    }
}

/// Between two states a broom that turns is shorter, at the middle of its chord, which the
/// tolerance covers only where the step is in proportion (docs/scenario.md).
bool step_suits_brooms(const core::Requirements& required) {
    constexpr double rounding = 1e-9;
    const double shorter = required.max_step * required.max_step / (2 * required.broom_length);
    return shorter <= required.tolerance * (1 + rounding);
}

void require_holds(const core::CheckResult& check) {
    require(check.ok(), "the path is valid, but " + std::string(core::name(check.check)) + ": " +
                            core::describe(check));
}

void require_valid(const core::Problem& problem, const core::Solution& solution) {
    const core::ValidationReport report = core::validate(
        problem, solution, {.tolerance = problem.requirements.tolerance, .continuous = true});
    for (const core::CheckResult& check : report.checks) require_holds(check);
    for (const core::CheckResult& check : report.motion)
        if (check.check != core::Check::broom_lengths || step_suits_brooms(problem.requirements))
            require_holds(check);
}

void require_kept(const core::Problem& problem, const core::SolveResult& result) {
    require(result.solution.has_value() == (result.status == core::SolveStatus::solved),
            "solved means a solution");
    if (!result.solution) return require(!result.reason.empty(), "no solution has a reason");
    require_valid(problem, *result.solution);
    constexpr double rounding = 1e-9;
    const core::SolveStatistics& figures = result.statistics;
    require(figures.cost_lower_bound <= result.solution->cost * (1 + rounding) + rounding,
            "no path costs less than the bound");
    require(figures.steps_lower_bound <= result.solution->path.size() - 1,
            "no path has fewer steps than the bound");
}

}  // namespace

void solve(std::string_view input) {
    const SmallCase drawn = small_case(input);
    try {
        const core::Problem problem = io::parse_scenario(drawn.scenario, "drawn", {}).problem;
        if (const auto result = solved(problem, drawn.options)) require_kept(problem, *result);
    } catch (const std::exception& error) {
        throw std::logic_error(std::string(error.what()) + "\nplanner " +
                               std::string(core::name(drawn.options.planner)) + ", seed " +
                               std::to_string(drawn.options.seed) + ", scenario\n" +
                               drawn.scenario);
    }
}

}  // namespace asv::fuzz
