#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/solution/solution_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"
#include "tests/tools/mpi/mpi_run.hpp"

/// One problem that several ranks race on.

namespace asv::test {
namespace {

using Words = std::vector<std::string>;

Words solving(const std::string& problem, const std::filesystem::path& file) {
    return {testcase_file(problem), file.string(), "--threads", "1", "--optimize", "0.1"};
}

TEST(SolveRanks, ThePathIsValidAndNotWorseThanThatOfRank0Alone) {
    const TemporaryFolder folder;
    for (const int ranks : {2, 3}) {
        const std::string problem = ranks == 2 ? "7ASV.txt" : "3ASV-clutter-20.txt";
        const auto alone = folder / "alone.txt", together = folder / "together.txt";
        ASSERT_EQ(run_program("asv-solve", solving(problem, alone)).exit_code, 0);
        const Outcome outcome = run_ranks(ranks, "asv-solve", solving(problem, together));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(contains(outcome.err, "of " + std::to_string(ranks) + " ranks of MPI"))
            << outcome.err;
        const Outcome verdict = run_program(
            "asv-validate", {testcase_file(problem), together.string(), "--continuous"});
        EXPECT_EQ(verdict.exit_code, 0) << verdict.out << verdict.err;
        // A rank that proves its path to be the best there is may be off by a share of 1e-5.
        const std::size_t asv_count = ranks == 2 ? 7 : 3;
        EXPECT_LE(io::read_solution(together, asv_count).cost,
                  io::read_solution(alone, asv_count).cost * (1 + 1e-5));
    }
}

TEST(SolveRanks, TheFirstPathServesAllWhereNothingIsToBeImproved) {
    const TemporaryFolder folder;
    Words words = solving("7ASV-x6.txt", folder / "out.txt");
    words.back() = "0";
    const Outcome outcome = run_ranks(3, "asv-solve", words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "out.txt"));
}

TEST(SolveRanks, AnswersThatAreNotPathsAreThoseOfOneProcess) {
    const TemporaryFolder folder;
    const auto code = [&](const std::string& problem, const Words& more) {
        Words words = solving(problem, folder / "out.txt");
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run_ranks(2, "asv-solve", words);
        EXPECT_FALSE(std::filesystem::exists(folder / "out.txt")) << problem;
        return outcome.exit_code;
    };
    EXPECT_EQ(code("infeasible/wall-across.txt", {"--time-limit", "30"}), 4);
    EXPECT_EQ(code("infeasible/wall-across.txt", {"--time-limit", "0.3"}), 1);
    EXPECT_EQ(code("infeasible/opposite-orientation.txt", {}), 4);
    EXPECT_EQ(code("7ASV.txt", {"--trees", (folder / "trees.json").string()}), 2);
    EXPECT_EQ(code("7ASV.txt", {"--batch", "no-such-file.jsonl"}), 2);
    EXPECT_EQ(code("no-such-file.txt", {}), 3);
}

}  // namespace
}  // namespace asv::test
