#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/problem/problem_digest.hpp"
#include "io/problem/problem_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"
#include "tests/tools/bench/bench_runs.hpp"
#include "tests/tools/mpi/mpi_run.hpp"
#include "tools/mpi/bench/plan_bytes.hpp"

/// A sweep whose runs are made by several ranks.

namespace asv::test {
namespace {

using nlohmann::json;

json json_of(const std::filesystem::path& file) {
    return json::parse(io::read_file(file));
}

void expect_same_rows(const json& one, const json& other) {
    EXPECT_EQ(one["problems"], other["problems"]);
    EXPECT_EQ(one["planners"], other["planners"]);
    EXPECT_EQ(one["session"]["jobs"], other["session"]["jobs"]);
    ASSERT_EQ(one["runs"].size(), other["runs"].size());
    for (std::size_t i = 0; i < one["runs"].size(); ++i)
        EXPECT_EQ(without_times(one["runs"][i]), without_times(other["runs"][i]));
}

/// Sixteen runs of chains and arms, four of which another program makes, and one that has no path.
Words small_sweep(const std::string& file) {
    const std::string outside = std::string("outside: exec ") + ASV_PROGRAM_DIR +
                                "/asv-solve {problem} {solution} --seed {seed} --quiet "
                                "--optimize 0 --threads 1 --time-limit {time}";
    return {testcase_file("3ASV.txt"),
            testcase_file("bodies/arm-3-plane.json"),
            "--seeds",
            "2",
            "--direction",
            "both",
            "--planner",
            "auto",
            "--planner",
            outside,
            "--json",
            file};
}

/// Twice as many runs as seeds, of some 50 ms each.
Words long_sweep(const TemporaryFolder& folder, const std::string& name,
                 const std::string& seeds = "20") {
    return {testcase_file("3ASV.txt"),
            "--quiet",
            "--seeds",
            seeds,
            "--direction",
            "both",
            "--optimize",
            "0.05",
            "--json",
            (folder / (name + ".json")).string(),
            "--csv",
            (folder / (name + ".csv")).string()};
}

std::size_t lines_of(const std::filesystem::path& file) {
    return std::filesystem::exists(file) ? count(io::read_file(file), "\n") : 0;
}

TEST(BenchRanks, TheRowsAreThoseOfOneProcess) {
    const TemporaryFolder folder;
    const auto in = [&](const std::string& name) { return (folder / name).string(); };
    for (const int ranks : {2, 3}) {
        Words here = small_sweep(in("here.json"));
        here.insert(here.end(), {"--quiet", "--jobs", std::to_string(ranks)});
        ASSERT_EQ(run_program("asv-bench", here).exit_code, 0);
        const Outcome outcome = run_ranks(ranks, "asv-bench", small_sweep(in("ranks.json")));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(contains(outcome.err, "16 runs on " + std::to_string(ranks) + " ranks of MPI"))
            << outcome.err;
        expect_same_rows(json_of(in("here.json")), json_of(in("ranks.json")));
    }
}

TEST(BenchRanks, ARankThatIsKilledCostsNoMoreThanTheRunsAtWork) {
    const TemporaryFolder folder;
    const auto journal = folder / "sweep.jsonl";
    Words whole = long_sweep(folder, "whole"), parts = long_sweep(folder, "parts");
    whole.insert(whole.end(), {"--jobs", "3"});
    parts.insert(parts.end(), {"--resume", journal.string()});
    ASSERT_EQ(run_program("asv-bench", whole).exit_code, 0);
    Surroundings killed;
    constexpr std::size_t enough_lines = 6;
    killed.first_signal_when = [&] {
        return lines_of(journal) >= enough_lines && kill_rank(1, journal.string());
    };
    EXPECT_NE(run_ranks(3, "asv-bench", parts, killed).exit_code, 0);
    const Outcome outcome = run_ranks(3, "asv-bench", parts);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_same_rows(json_of(folder / "whole.json"), json_of(folder / "parts.json"));
    EXPECT_EQ(count(io::read_file(journal), "\"cost_history\":"), 40U) << "a run was made twice";
}

TEST(BenchRanks, CtrlCWritesWhatThereIs) {
    const TemporaryFolder folder;
    const auto journal = folder / "sweep.jsonl";
    // More than there is time for.
    Words sweep = long_sweep(folder, "some", "10000");
    sweep.insert(sweep.end(), {"--resume", journal.string()});
    Surroundings interrupted;
    constexpr std::size_t enough_lines = 4;
    interrupted.first_signal_when = [&] { return lines_of(journal) >= enough_lines; };
    interrupted.before_each_signal = 1;
    interrupted.signals = {SIGINT};
    // mpirun passes the signal on after so many seconds, and kills after as many again. A busy
    // machine has to write its results before that.
    interrupted.environment = {"OMPI_MCA_odls_base_sigkill_timeout=3"};
    run_ranks(2, "asv-bench", sweep, interrupted);
    ASSERT_TRUE(std::filesystem::exists(folder / "some.csv"));
    EXPECT_GE(lines_of(folder / "some.csv"), enough_lines);
    EXPECT_FALSE(json_of(folder / "some.json")["session"]["complete"]);
}

TEST(BenchRanks, WrongUsageIsSaidOnce) {
    const Outcome outcome = run_ranks(2, "asv-bench", {testcase_file("3ASV.txt"), "--jobs", "2"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(count(outcome.err, "--jobs: under MPI"), 1U) << outcome.err;
}

TEST(BenchRanks, APlanArrivesAsItWas) {
    core::BenchmarkPlan plan;
    for (const char* name : {"7ASV.txt", "bodies/arm-3-workshop.json", "bodies/arm-3-plane.json"}) {
        const io::ProblemFile read = io::read_problem(testcase_file(name));
        plan.problems.push_back(
            {name, testcase_file(name), read.problem, io::problem_digest(read.problem)});
    }
    plan.planners = {{"auto", core::AutoPlanner{}, {}}, {"mine", {}, {}, {"exec", "{problem}"}}};
    plan.time_limit = 0.1;
    plan.memory_limit = 77;
    const core::BenchmarkPlan copy = tools::plan_of(tools::plan_bytes(plan));
    ASSERT_EQ(copy.problems.size(), plan.problems.size());
    for (std::size_t i = 0; i < plan.problems.size(); ++i) {
        EXPECT_EQ(io::problem_digest(copy.problems[i].problem), plan.problems[i].digest);
        EXPECT_EQ(copy.problems[i].file, plan.problems[i].file);
    }
    EXPECT_EQ(copy.planners[1].command, plan.planners[1].command);
    EXPECT_EQ(copy.time_limit, plan.time_limit);
    EXPECT_EQ(copy.memory_limit, plan.memory_limit);
    plan.problems[0].digest = "0";
    EXPECT_THROW(tools::plan_of(tools::plan_bytes(plan)), std::logic_error);
}

}  // namespace
}  // namespace asv::test
