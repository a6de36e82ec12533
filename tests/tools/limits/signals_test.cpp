#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"

/// INT, TERM and HUP end every program, whatever it is doing; what would go on without them is
/// ended after a minute, by another signal.

namespace asv::test {
namespace {

using Words = std::vector<std::string>;

constexpr int interrupted = 130;

Surroundings sending(std::vector<int> signals) {
    Surroundings surroundings;
    surroundings.signals = std::move(signals);
    return surroundings;
}

std::string pipe_in(const TemporaryFolder& folder) {
    std::string pipe = folder / "pipe";
    EXPECT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    return pipe;
}

/// Whether a benchmark has noted a run that has ended: its journal has a line beside the first one.
bool notes_a_run(const std::string& journal) {
    if (!std::filesystem::exists(journal)) return false;
    const std::string text = io::read_file(journal);
    return std::count(text.begin(), text.end(), '\n') >= 2;
}

/// A benchmark that would take an hour, ended when its first run has ended.
Outcome ended_benchmark(int signal, const std::string& journal, const Words& outputs) {
    Surroundings surroundings = sending({signal});
    surroundings.first_signal_when = [&journal] { return notes_a_run(journal); };
    Words words{
        testcase_file("3ASV.txt"), "--seeds", "1000000", "--optimize", "0", "--resume", journal};
    words.insert(words.end(), outputs.begin(), outputs.end());
    return run_program("asv-bench", words, surroundings);
}

class EverySignal : public testing::TestWithParam<int> {};

TEST_P(EverySignal, EndsImprovementWithTheBestPathWritten) {
    const TemporaryFolder folder;
    const std::string problem = testcase_file("3ASV.txt"), solution = folder / "s";
    const Outcome outcome =
        run_program("asv-solve", {problem, solution, "--optimize", "1000", "--time-limit", "1000"},
                    sending({GetParam()}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(run_program("asv-validate", {problem, solution, "--continuous"}).exit_code, 0);
    EXPECT_EQ(folder.entries(), 1);
}

TEST_P(EverySignal, EndsWhatWaitsForAReader) {
    const TemporaryFolder folder;
    const std::string problem = testcase_file("3ASV.txt"), pipe = pipe_in(folder);
    const std::vector<std::pair<std::string, Words>> calls{
        {"asv-solve", {problem, pipe, "--quiet", "--optimize", "0"}},
        {"asv-validate", {problem, "--json", pipe}},
        {"asv-generate", {"corridor", "-n", "5", "-o", pipe}},
        {"asv-bench", {problem, "--optimize", "0", "--csv", pipe}}};
    for (const auto& [program, arguments] : calls)
        EXPECT_EQ(run_program(program, arguments, sending({GetParam()})).exit_code, interrupted)
            << program;
}

TEST_P(EverySignal, EndsWhatWaitsForItsInput) {
    const TemporaryFolder folder;
    const std::string pipe = pipe_in(folder), out = folder / "o.svg";
    const std::vector<std::pair<std::string, Words>> calls{{"asv-solve", {pipe, out, "--quiet"}},
                                                           {"asv-validate", {pipe}},
                                                           {"asv-view", {pipe, "-o", out}},
                                                           {"asv-bench", {pipe}}};
    for (const auto& [program, arguments] : calls)
        EXPECT_EQ(run_program(program, arguments, sending({GetParam()})).exit_code, interrupted)
            << program;
    EXPECT_EQ(folder.entries(), 1) << "only the pipe";
}

TEST_P(EverySignal, EndsABenchmarkWithItsResultsWritten) {
    const TemporaryFolder folder;
    const std::string csv = folder / "runs.csv";
    const Outcome outcome =
        ended_benchmark(GetParam(), folder / "journal", {"--csv", csv, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Interrupted"), std::string::npos);
    EXPECT_NE(io::read_file(csv).find("3ASV"), std::string::npos);
}

TEST_P(EverySignal, EndsABenchmarkWhoseResultsNobodyReads) {
    const TemporaryFolder folder;
    const std::string csv = folder / "runs.csv", pipe = pipe_in(folder);
    const Outcome outcome =
        ended_benchmark(GetParam(), folder / "journal", {"--json", pipe, "--csv", csv});
    EXPECT_EQ(outcome.exit_code, interrupted) << outcome.err;
    EXPECT_NE(io::read_file(csv).find("3ASV"), std::string::npos) << "files do not wait for it";
}

INSTANTIATE_TEST_SUITE_P(Ours, EverySignal, testing::Values(SIGINT, SIGTERM, SIGHUP));

/// An arm of so many links that its steps alone take minutes.
std::string long_arm() {
    std::string links, start, goal;
    for (int i = 0; i < 2000; ++i) {
        const std::string comma = i == 0 ? "" : ",";
        links += comma + "0.01";
        start += comma + "0.01";
        goal += comma + "0.02";
    }
    return R"({"version": 1, "bounds": null, "step": 0.001, "body": {"kind": "arm", "base": [0.5, 0.5],
"angles": "relative", "joints": "wrap", "links": [)" +
           links + "]}, \"start\": [" + start + "], \"goal\": [" + goal + "]}";
}

TEST(Signals, EndALargeBodyToo) {
    const TemporaryFolder folder;
    const std::string problem = folder / "p.json", stats = folder / "j";
    io::write_file(problem, long_arm());
    const Outcome outcome =
        run_program("asv-solve", {problem, folder / "s", "--stats", stats}, sending({SIGINT}));
    EXPECT_EQ(outcome.exit_code, interrupted) << outcome.err;
    EXPECT_NE(io::read_file(stats).find("\"interrupted\""), std::string::npos);
    EXPECT_EQ(folder.entries(), 2);
}

TEST(Signals, AHangupThatWasToBeIgnoredIsIgnored) {
    const TemporaryFolder folder;
    const Words words{
        testcase_file("7ASV.txt"), folder / "undisturbed", "--optimize", "2", "--threads", "1"};
    EXPECT_EQ(run_program("asv-solve", words).exit_code, 0);
    Words disturbed = words;
    disturbed[1] = folder / "disturbed";
    Surroundings hangup = sending({SIGHUP});
    hangup.before_each_signal = 300;
    std::signal(SIGHUP, SIG_IGN);
    const Outcome outcome = run_program("asv-solve", disturbed, hangup);
    std::signal(SIGHUP, SIG_DFL);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    // Had the signal ended the improvement, the path would be another one.
    EXPECT_EQ(io::read_file(disturbed[1]), io::read_file(words[1]));
}

}  // namespace
}  // namespace asv::test
