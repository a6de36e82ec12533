#include "tests/kit/solving.hpp"

#include "core/model/cost.hpp"
#include "tests/kit/check_results.hpp"

namespace asv::test {

core::SolveOptions plain(std::uint64_t seed) {
    core::SolveOptions options;
    options.seed = seed;
    options.optimize = 0;
    options.time_limit = 600;
    return options;
}

void expect_solved(const core::Problem& problem, const core::SolveResult& result) {
    ASSERT_EQ(result.status, core::SolveStatus::solved) << result.reason;
    ASSERT_TRUE(result.solution);
    EXPECT_TRUE(result.reason.empty());
    expect_valid(core::validate(problem, *result.solution, {.continuous = true}));
    if (::testing::Test::HasFatalFailure()) return;
    EXPECT_DOUBLE_EQ(result.solution->cost, core::cost(problem, result.solution->path));
    EXPECT_EQ(result.statistics.cost, result.solution->cost);
}

}  // namespace asv::test
