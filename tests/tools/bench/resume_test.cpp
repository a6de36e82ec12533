#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"
#include "tests/kit/sanitizers.hpp"
#include "tests/tools/bench/bench_runs.hpp"

/// A sweep that goes on where it was, and runs that are taken from files.

namespace asv::test {
namespace {

using nlohmann::json;

json json_of(const std::filesystem::path& file) {
    return json::parse(io::read_file(file));
}

/// Eighty runs of some milliseconds each.
Words sweep(const std::string& file) {
    return {testcase_file("bodies/arm-1-plane.json"),
            testcase_file("bodies/arm-3-plane.json"),
            "--quiet",
            "--seeds",
            "10",
            "--direction",
            "both",
            "--planner",
            "auto",
            "--planner",
            "rrt",
            "--time-limit",
            "600",
            "--json",
            file};
}

void expect_same_runs(const json& one, const json& other) {
    ASSERT_EQ(one["runs"].size(), other["runs"].size());
    for (std::size_t i = 0; i < one["runs"].size(); ++i)
        EXPECT_EQ(without_times(one["runs"][i]), without_times(other["runs"][i]));
}

TEST(Resume, ASweepThatIsKilledAgainAndAgainGivesTheSameRows) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    ASSERT_EQ(run_program("asv-bench", sweep(in("whole.json"))).exit_code, 0);
    Words resumed = sweep(in("parts.json"));
    resumed.insert(resumed.end(), {"--resume", in("sweep.jsonl")});
    for (const unsigned milliseconds : {250U, 400U, 550U, 700U, 1000U, 1500U}) {
        Surroundings killed;
        killed.signals = {SIGKILL};
        killed.before_each_signal = milliseconds;
        const Outcome outcome = run_program("asv-bench", resumed, killed);
        ASSERT_TRUE(outcome.exit_code == -SIGKILL || outcome.exit_code == 0) << outcome.err;
        if (std::filesystem::exists(folder / "sweep.jsonl"))
            std::cout << "after " << milliseconds
                      << " ms: " << count(io::read_file(folder / "sweep.jsonl"), "\n")
                      << " lines\n";
    }
    const Outcome last = run_program("asv-bench", resumed);
    ASSERT_EQ(last.exit_code, 0) << last.err;
    const json whole = json_of(folder / "whole.json"), parts = json_of(folder / "parts.json");
    EXPECT_TRUE(parts["session"]["complete"]);
    expect_same_runs(whole, parts);
}

/// Every run in the journal is taken over as it is, and the rest is run.
TEST(Resume, GoesOnBehindTheLastWholeLine) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    const Words problem{testcase_file("3ASV.txt")};
    const Words options{"--resume", in("j"), "--json", in("b.json")};
    ASSERT_EQ(bench(problem, options).exit_code, 0);
    const json first = json_of(folder / "b.json");
    const std::string journal = io::read_file(folder / "j");
    const std::size_t second_run = journal.find("\"seed\":2,");
    std::ofstream(folder / "j") << journal.substr(0, second_run);
    ASSERT_EQ(bench(problem, options).exit_code, 0);
    const json second = json_of(folder / "b.json");
    EXPECT_EQ(second["runs"][0], first["runs"][0]) << "with its times";
    expect_same_runs(first, second);
    EXPECT_EQ(second["session"]["parts"].size(), 2U);
    const Outcome table = run_program("asv-bench", {"--from", in("j"), "--quiet"});
    EXPECT_TRUE(contains(table.out, "| 3ASV | 2 of 2 |")) << table.out << table.err;
}

TEST(Resume, AJournalOfAnotherBenchmarkIsRefusedAndLeftAlone) {
    const TemporaryFolder folder;
    const std::string journal = (folder / "j").string();
    const std::string problem = (folder / "3ASV.txt").string();
    std::filesystem::copy_file(testcase_file("3ASV.txt"), problem);
    ASSERT_EQ(bench({problem}, {"--resume", journal}).exit_code, 0);
    const std::string before = io::read_file(journal);
    const auto expect_refused = [&](const Words& options, const std::string& message) {
        Words all{"--resume", journal};
        all.insert(all.end(), options.begin(), options.end());
        const Outcome outcome = bench({problem}, all);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_TRUE(contains(outcome.err, message)) << outcome.err;
    };
    expect_refused({"--time-limit", "5"}, "time limit: 5 s here, 10 s there");
    expect_refused({"--planner", "rrt"}, "planners: rrt here, auto there");
    expect_refused({"--planner", "auto: rrt"}, "planner auto: rrt here, auto there");
    expect_refused({"--first-seed", "2"}, "seeds: 2 to 3 here, 1 to 2 there");
    io::write_file(problem, io::read_file(testcase_file("3ASV-x4.txt")));
    expect_refused({}, "content of problem 3ASV: ");
    EXPECT_EQ(io::read_file(journal), before);
    const Outcome no_journal = bench({testcase_file("3ASV.txt")}, {"--resume", problem});
    EXPECT_EQ(no_journal.exit_code, 2);
    EXPECT_TRUE(contains(no_journal.err, "no journal")) << no_journal.err;
    EXPECT_EQ(io::read_file(problem), io::read_file(testcase_file("3ASV-x4.txt")));
}

TEST(Resume, NeedsAFileOfItsOwn) {
    const TemporaryFolder folder;
    const std::string journal = (folder / "j").string(), pipe = (folder / "p").string();
    const auto refusal = [](const std::string& file) {
        const Outcome outcome = bench({testcase_file("3ASV.txt")}, {"--resume", file});
        EXPECT_EQ(outcome.exit_code, 2) << file;
        return outcome.err;
    };
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(refusal(pipe), "asv-bench: --resume " + pipe + ": not a regular file\n");
    const int held = ::open(journal.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    ASSERT_EQ(::flock(held, LOCK_EX), 0);
    EXPECT_EQ(refusal(journal),
              "asv-bench: --resume " + journal + ": another asv-bench is writing it\n");
    ::close(held);
    const Outcome nowhere =
        bench({testcase_file("3ASV.txt")}, {"--resume", (folder / "no/j").string()});
    EXPECT_EQ(nowhere.exit_code, 5);
    EXPECT_TRUE(contains(nowhere.err, "no/j: No such file or directory")) << nowhere.err;
}

/// The journal of a sweep that is over is taken as it is: no run is run twice, and none is added.
TEST(Resume, OfWhatIsDoneRunsNothing) {
    const TemporaryFolder folder;
    const Words options{"--resume", (folder / "j").string(), "--table", "-"};
    ASSERT_EQ(bench({testcase_file("3ASV.txt")}, options).exit_code, 0);
    const std::string journal = io::read_file(folder / "j");
    EXPECT_TRUE(contains(bench({testcase_file("3ASV.txt")}, options).out, "| 3ASV | 2 of 2 |"));
    EXPECT_EQ(io::read_file(folder / "j"), journal);
}

TEST(From, MakesTheSameFilesWithoutARun) {
    const TemporaryFolder folder;
    const auto in = [&](const std::string& name) { return (folder / name).string(); };
    const auto outputs = [&](const std::string& name) {
        return Words{"--json",     in(name + ".json"), "--csv",  in(name + ".csv"),
                     "--table",    in(name + ".md"),   "--plot", in(name + ".svg"),
                     "--database", in(name + ".db")};
    };
    ASSERT_EQ(bench({testcase_file("3ASV.txt"), testcase_file("bodies/arm-3-workshop.json")},
                    outputs("a"))
                  .exit_code,
              0);
    Words again = outputs("b");
    again.insert(again.end(), {"--from", in("a.json")});
    const Outcome outcome = run_program("asv-bench", again);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* ending : {".json", ".csv", ".md", ".svg", ".db"})
        EXPECT_EQ(io::read_file(in(std::string("a") + ending)),
                  io::read_file(in(std::string("b") + ending)))
            << ending;
}

TEST(From, AddsAPlannerAndRunsOnlyThat) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    ASSERT_EQ(bench({testcase_file("3ASV.txt")}, {"--json", in("a.json")}).exit_code, 0);
    const Outcome outcome = run_program("asv-bench", {"--from", in("a.json"), "--planner", "rrt",
                                                      "--json", in("b.json"), "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json a = json_of(folder / "a.json"), b = json_of(folder / "b.json");
    ASSERT_EQ(b["runs"].size(), 4U);
    EXPECT_EQ(b["runs"][0], a["runs"][0]) << "with its times";
    EXPECT_EQ(b["runs"][1], a["runs"][1]) << "with its times";
    EXPECT_EQ(b["runs"][2]["planner"], "rrt");
    EXPECT_EQ(b["runs"][3]["status"], "solved");
    const Outcome twice =
        run_program("asv-bench", {"--from", in("a.json"), "--from", in("b.json")});
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_TRUE(contains(twice.err, "3ASV forward, auto, seed 1 is in")) << twice.err;
}

/// More runs belong to what there is: the same planner, problem and version.
TEST(From, RefusesAPlannerThatDoesNotBelongToTheRuns) {
    const TemporaryFolder folder;
    const std::string problem = (folder / "p.txt").string(), file = (folder / "a.json").string();
    io::write_file(problem, io::read_file(testcase_file("3ASV.txt")));
    ASSERT_EQ(bench({problem}, {"--json", file}).exit_code, 0);
    const auto refusal = [&](const std::string& planner) {
        const Outcome outcome = run_program("asv-bench", {"--from", file, "--planner", planner});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    EXPECT_EQ(refusal("auto: rrt"),
              "asv-bench: planner auto is rrt here, auto in the files of --from; give it another "
              "label\n");
    io::write_file(problem, io::read_file(testcase_file("3ASV-x4.txt")));
    EXPECT_EQ(refusal("rrt"), "asv-bench: " + problem +
                                  " is not the problem that the runs of --from are of: its content "
                                  "has changed\n");
    json old = json_of(file);
    old["session"]["version"] = "0.0.1";
    io::write_file(file, old.dump());
    EXPECT_TRUE(refusal("rrt").starts_with(
        "asv-bench: the runs of --from are of version 0.0.1, and do not compare with those of "));
}

TEST(From, LeavesNoRoomForOptionsOfThePlan) {
    EXPECT_EQ(run_program("asv-bench", {"--from", "a.json", "--seeds", "3"}).exit_code, 2);
    EXPECT_EQ(run_program("asv-bench", {"b.txt", "--from", "a.json"}).exit_code, 2);
    EXPECT_EQ(run_program("asv-bench", {}).exit_code, 2);
    EXPECT_EQ(run_program("asv-bench", {"--from", testcase_file("3ASV.txt")}).exit_code, 3);
}

TEST(MemoryLimit, ARunThatWantsMoreIsAResultOfItsOwnKind) {
    if (sanitized) GTEST_SKIP() << "a sanitizer wants memory of its own";
    const TemporaryFolder folder;
    const std::string file = (folder / "b.json").string();
    // A grid of configurations of which only a part fits.
    const Words problem{testcase_file("7ASV.txt"), "--planner", "prm-grid", "--json", file};
    const Outcome outcome = bench(problem, {"--memory-limit", "2", "--table", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "memory-limit (it wanted more than 2 MB of memory)"))
        << outcome.out;
    const json report = json_of(file);
    EXPECT_EQ(report["session"]["memory_limit_mb"], 2);
    for (const json& run : report["runs"]) EXPECT_EQ(run["status"], "memory-limit");
    ASSERT_EQ(bench(problem, {"--memory-limit", "500"}).exit_code, 0);
    const json solved = json_of(file);
    for (const json& run : solved["runs"]) EXPECT_EQ(run["status"], "solved");
}

}  // namespace
}  // namespace asv::test
