#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/files/random_files.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

RC_GTEST_PROP(RoundTrip, ProblemsReadBackToTheSameNumbers, (std::uint64_t seed)) {
    test::Random random(seed);
    const test::TemporaryFolder folder;
    const core::Problem problem = test::random_problem(random);
    write_problem(folder / "p", problem);
    const ProblemFile back = read_problem(folder / "p");
    // Some of the obstacles are thinner than the tolerance, which is told.
    for (const Warning& warning : back.warnings)
        RC_ASSERT(warning.message.find("vanishes") != std::string::npos);
    RC_ASSERT(back.problem.start == problem.start);
    RC_ASSERT(back.problem.goal == problem.goal);
    RC_ASSERT(back.problem.obstacles == problem.obstacles);
}

RC_GTEST_PROP(RoundTrip, SolutionsReadBackToTheSameNumbers, (std::uint64_t seed)) {
    test::Random random(seed);
    const test::TemporaryFolder folder;
    const std::size_t asv_count = 1 + random.below(30);
    const core::Solution solution = test::random_solution(random, asv_count);
    write_solution(folder / "s", solution);
    const core::Solution back = read_solution(folder / "s", asv_count);
    RC_ASSERT(back.path == solution.path);
    RC_ASSERT(back.cost == solution.cost);
}

RC_GTEST_PROP(RoundTrip, WritingTwiceGivesTheSameBytes, (std::uint64_t seed)) {
    test::Random random(seed);
    const test::TemporaryFolder folder;
    const core::Solution solution = test::random_solution(random, 3);
    write_solution(folder / "a", solution);
    write_solution(folder / "b", read_solution(folder / "a", 3));
    RC_ASSERT(read_file(folder / "a") == read_file(folder / "b"));
}

}  // namespace
}  // namespace asv::io
