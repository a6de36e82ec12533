#include <optional>
#include <string>
#include <vector>

#include "core/validation/validate.hpp"
#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

namespace {

constexpr std::string_view separator = "\n---\n";
constexpr double tolerance = 1e-5;

std::optional<core::Problem> problem_of(std::string_view text) {
    try {
        return io::parse_problem(text, "problem").problem;
    } catch (const io::ParseError&) {
        return std::nullopt;
    }
}

/// Every result can be said, and tells as many offenders as it counts.
void require_told(const std::vector<core::CheckResult>& results) {
    for (const core::CheckResult& result : results) {
        require(!core::describe(result).empty(), "a check can be described");
        require(result.offenders.size() == result.failures, "every failure has its offender");
        for (const core::Offender& offender : result.offenders)
            require(!core::describe(result.check, offender).empty(), "a failure can be described");
    }
}

void require_same_verdicts(const core::ValidationReport& a, const core::ValidationReport& b) {
    require(a.checks.size() == b.checks.size(), "the same checks are made");
    for (std::size_t i = 0; i < a.checks.size(); ++i)
        require(a.checks[i].failures == b.checks[i].failures,
                "the verdict on states does not depend on what else is asked for");
}

void require_consistent(const core::Problem& problem, const core::Solution& solution) {
    const core::ValidationReport report = core::validate(problem, solution, {tolerance});
    const core::ValidationReport all = core::validate(
        problem, solution, {.tolerance = tolerance, .continuous = true, .list_offenders = true});
    require_same_verdicts(report, all);
    require_told(all.checks);
    require_told(all.motion);
    require(report.valid() || !all.valid(), "a path is not valid for more being asked");
    const core::ValidationReport strict = core::validate(problem, solution, {0.0});
    for (std::size_t i = 0; i < strict.checks.size(); ++i)
        require(strict.checks[i].failures >= report.checks[i].failures,
                "a smaller tolerance forgives no more");
}

}  // namespace

void solution(std::string_view input) {
    const std::size_t end = input.find(separator);
    const std::optional<core::Problem> asked = problem_of(input.substr(0, end));
    if (!asked || end == std::string_view::npos) return;
    const std::string_view text = input.substr(end + separator.size());
    try {
        const core::Solution read = io::parse_solution(text, asked->asv_count(), "solution");
        const std::string written = io::format_solution(read);
        require(io::parse_solution(written, asked->asv_count(), "written").path == read.path,
                "a solution that was written reads back to the same numbers");
        require_consistent(*asked, read);
    } catch (const io::ParseError& error) {
        require_place_in(text, error);
    }
}

}  // namespace asv::fuzz
