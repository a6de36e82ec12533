#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"

/// What a time limit and a system that grants little make of a run, and what is said of it.

namespace asv::test {
namespace {

TEST(TimeLimits, EndWhatWaitsForAReader) {
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe.csv";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const std::string problem = testcase_file("3ASV.txt"), solution = folder / "s";
    for (const char* option : {"", "--stats", "--trajectory", "--trees"}) {
        SCOPED_TRACE(option);
        const bool of_solution = *option == '\0';
        std::vector<std::string> arguments{
            problem, of_solution ? pipe : solution, "--optimize", "0", "--time-limit", "0.5"};
        if (!of_solution) arguments.insert(arguments.end(), {option, pipe});
        if (option == std::string("--trajectory"))
            arguments.insert(arguments.end(), {"--speed", "1", "--acceleration", "1"});
        const Outcome outcome = run_program("asv-solve", arguments);
        EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
        EXPECT_NE(outcome.err.find("time limit"), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(folder.entries(), 2) << "the pipe and the solution";
}

/// Its path has millions of steps.
constexpr const char* long_way =
    R"({"version": 1, "body": {"kind": "point"}, "start": [0, 0], "goal": [60000, 0], "bounds": null})";

TEST(TimeLimits, TellThatThereWasAPathWhichTookTooLongToWrite) {
    const TemporaryFolder folder;
    const std::string problem = folder / "p.json", stats = folder / "j";
    io::write_file(problem, long_way);
    const Outcome outcome = run_program("asv-solve", {problem, folder / "s", "--time-limit", "0.8",
                                                      "--threads", "1", "--stats", stats});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("path was found after"), std::string::npos) << outcome.err;
    const auto json = nlohmann::json::parse(io::read_file(stats));
    EXPECT_EQ(json["status"], "timeout");
    EXPECT_NE(json["reason"].get<std::string>().find("found after"), std::string::npos);
    EXPECT_EQ(folder.entries(), 2) << "nothing of a solution";
}

TEST(TimeLimits, ManyThreadsDoNotCostThePath) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program("asv-solve", {testcase_file("3ASV.txt"), folder / "s",
                                                      "--threads", "1024", "--time-limit", "4"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(FewProcesses, MakeFewerThreadsNotAFailure) {
    const TemporaryFolder folder;
    const std::string problem = folder / "p.txt", solution = folder / "s";
    io::write_file(problem, io::read_file(testcase_file("3ASV.txt")));
    std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
    Surroundings surroundings;
    // The limit does not bind root; a user of its own has no other processes.
    surroundings.user = ::geteuid() == 0 ? 54321 : 0;
    for (const unsigned most : {1U, 2U, 4U}) {
        surroundings.most_processes = most;
        const Outcome outcome =
            run_program("asv-solve", {problem, solution, "--threads", "16", "--optimize", "0.05"},
                        surroundings);
        EXPECT_EQ(outcome.exit_code, 0) << most << ": " << outcome.err;
    }
}

TEST(Statistics, TheLastCostOfTheHistoryIsTheCost) {
    const TemporaryFolder folder;
    const std::string stats = folder / "j";
    for (const char* file : {"7ASV.txt", "bodies/arm-3-workshop.json", "bodies/point-town.json"})
        for (const char* seed : {"1", "3"}) {
            SCOPED_TRACE(std::string(file) + ", seed " + seed);
            ASSERT_EQ(run_program("asv-solve",
                                  {testcase_file(file), folder / "s", "--seed", seed, "--threads",
                                   "1", "--optimize", "0.1", "--quiet", "--stats", stats})
                          .exit_code,
                      0);
            const auto json = nlohmann::json::parse(io::read_file(stats));
            const auto& history = json["cost_history"];
            ASSERT_FALSE(history.empty());
            EXPECT_EQ(history.back()[1], json["cost"]);
            EXPECT_EQ(history.front()[1], json["cost_first"]);
            for (std::size_t i = 1; i < history.size(); ++i) {
                EXPECT_LT(history[i][1], history[i - 1][1]);
                EXPECT_GE(history[i][0], history[i - 1][0]);
            }
        }
}

}  // namespace
}  // namespace asv::test
