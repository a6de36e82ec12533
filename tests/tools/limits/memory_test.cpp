#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/sanitizers.hpp"

/// A program whose allocation fails says so and ends with its exit code: it is not aborted.

namespace asv::test {
namespace {

using Words = std::vector<std::string>;

/// The outcome when the allocation of this number fails.
Outcome with_failure(const std::string& program, const Words& arguments, long allocation) {
    Surroundings surroundings;
    surroundings.environment = {"LD_PRELOAD=" ASV_FAILING_MALLOC,
                                "ASV_FAILING_ALLOCATION=" + std::to_string(allocation)};
    return run_program(program, arguments, surroundings);
}

/// The first allocations one by one, then fewer and fewer, until the program makes no more.
void fail_everywhere(const std::string& program, const Words& arguments) {
    int failed = 0;
    int untouched = 0;
    for (long k = 1; untouched < 4 && k < 10'000'000; k += 1 + k / 4) {
        SCOPED_TRACE("allocation " + std::to_string(k));
        const Outcome outcome = with_failure(program, arguments, k);
        untouched = outcome.exit_code == 0 ? untouched + 1 : 0;
        if (outcome.exit_code == 0) continue;
        ++failed;
        // 3 and 5: the system itself has no memory for a file.
        const bool told =
            outcome.exit_code == 70 || outcome.exit_code == 3 || outcome.exit_code == 5;
        EXPECT_TRUE(told) << outcome.exit_code << ": " << outcome.err;
        EXPECT_NE(outcome.err, "");
    }
    EXPECT_GT(failed, 10);
}

class EveryProgram : public testing::TestWithParam<std::string> {};

TEST_P(EveryProgram, SaysThatItHasNoMemory) {
    if (sanitized) GTEST_SKIP() << "a sanitizer has its own malloc";
    const TemporaryFolder folder;
    const std::string problem = testcase_file("3ASV.txt"), out = folder / "o";
    const std::string program = GetParam();
    Words arguments{problem};
    if (program == "asv-solve") arguments = {problem, out, "--optimize", "0", "--threads", "2"};
    if (program == "asv-view") arguments = {problem, "-o", out + ".html"};
    if (program == "asv-bench") arguments = {problem, "--seeds", "1"};
    if (program == "asv-generate") arguments = {"corridor", "-n", "5", "-o", out};
    fail_everywhere(program, arguments);
}

INSTANTIATE_TEST_SUITE_P(Ours, EveryProgram,
                         testing::Values("asv-solve", "asv-validate", "asv-view", "asv-bench",
                                         "asv-generate"),
                         [](const auto& tested) { return tested.param.substr(4); });

}  // namespace
}  // namespace asv::test
