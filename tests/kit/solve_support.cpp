#include "tests/kit/solve_support.hpp"

#include <filesystem>

#include "core/model/cost.hpp"
#include "core/validation/validate.hpp"
#include "io/problem/problem_file.hpp"

namespace asv::core::testing {

Problem testcase(const std::string& file) {
    return io::read_problem(std::filesystem::path(ASV_SOURCE_DIR) / "testcases" / file).problem;
}

SolveOptions plain(std::uint64_t seed) {
    SolveOptions options;
    options.seed = seed;
    options.optimize = 0;
    options.time_limit = 600;
    return options;
}

void expect_solved(const Problem& problem, const SolveResult& result) {
    ASSERT_EQ(result.status, SolveStatus::solved) << result.reason;
    ASSERT_TRUE(result.solution);
    EXPECT_TRUE(result.reason.empty());
    const ValidationReport report = validate(problem, *result.solution, {.continuous = true});
    for (const auto* checks : {&report.checks, &report.motion})
        for (const CheckResult& check : *checks)
            ASSERT_TRUE(check.ok()) << name(check.check) << ": " << describe(check);
    EXPECT_DOUBLE_EQ(result.solution->cost, cost(result.solution->path));
    EXPECT_EQ(result.statistics.cost, result.solution->cost);
}

}  // namespace asv::core::testing
