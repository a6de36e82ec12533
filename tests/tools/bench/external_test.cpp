#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"
#include "tests/kit/sanitizers.hpp"
#include "tests/tools/bench/bench_runs.hpp"

/// Planners that are other programs.

namespace asv::test {
namespace {

using nlohmann::json;

/// A program of these lines of shell, in whose words problem and solution are $1 and $2.
std::string script(const TemporaryFolder& folder, const std::string& name,
                   const std::string& lines) {
    const std::filesystem::path file = folder / name;
    std::ofstream(file) << "#!/bin/sh\n" << lines << '\n';
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file.string();
}

/// The first run of the script on 3ASV, and what the table says of it.
json run_of(const std::string& lines, const Words& more = {}) {
    const TemporaryFolder folder;
    const std::string file = (folder / "b.json").string();
    const std::string program = script(folder, "it.sh", lines);
    Words options{"--time-limit", "0.3",
                  "--json",       file,
                  "--table",      "-",
                  "--planner",    "it: exec " + program + " {problem} {solution} {seed} {time}"};
    options.insert(options.end(), more.begin(), more.end());
    const Outcome outcome = bench({testcase_file("3ASV.txt")}, options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json run = json::parse(io::read_file(file))["runs"][0];
    const std::string status = run["status"];
    EXPECT_TRUE(status == "solved" || contains(outcome.out, "it: " + status + " (")) << outcome.out;
    return run;
}

/// The same costs as in the process of a run, in both directions and for every body.
TEST(ExternalPlanner, AsvSolveFindsWhatThePlannerFindsInside) {
    const TemporaryFolder folder;
    const std::string file = (folder / "b.json").string();
    const std::string command = std::string("outside: exec ") + ASV_PROGRAM_DIR +
                                "/asv-solve {problem} {solution} --seed {seed} --time-limit {time} "
                                "--optimize 0 --threads 1 --quiet";
    const Outcome outcome =
        bench({testcase_file("3ASV.txt"), testcase_file("bodies/arm-3-workshop.json")},
              {"--direction", "both", "--planner", "auto", "--planner", command, "--json", file,
               "--table", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "| outside | 2 of 2 |")) << outcome.out;
    const json runs = json::parse(io::read_file(file))["runs"];
    ASSERT_EQ(runs.size(), 16U);
    for (std::size_t i = 0; i < runs.size(); i += 4)
        for (std::size_t seed = 0; seed < 2; ++seed) {
            const json& inside = runs[i + seed];
            const json& outside = runs[i + 2 + seed];
            ASSERT_EQ(outside["planner"], "outside");
            ASSERT_EQ(outside["status"], "solved") << outside["reason"];
            // Reversed, the file's states are added up the other way.
            EXPECT_NEAR(outside["cost"], inside["cost"], 1e-9 * inside["cost"].get<double>());
            EXPECT_EQ(outside["primitive_steps"], inside["primitive_steps"]);
            EXPECT_NEAR(outside["cost_lower_bound"], inside["cost_lower_bound"], 1e-9);
        }
}

/// What the lines of a script lead to.
struct End {
    std::string lines, status, reason;
};

TEST(ExternalPlanner, EndsAreToldApart) {
    const TemporaryFolder folder;
    const std::string solution = (folder / "s.txt").string();
    ASSERT_EQ(run_program("asv-solve", {testcase_file("3ASV.txt"), solution, "--quiet"}).exit_code,
              0);
    const std::vector<End> ends{{"exit 0", "no-path", "it wrote no solution"},
                                {"exit 4", "infeasible", "it says that there is no path"},
                                {"echo first >&2; echo 'at last' >&2; exit 3", "crash",
                                 "it ended with exit code 3: at last"},
                                {"exit 1", "crash", "it ended with exit code 1"},
                                {"kill -SEGV $$", "crash", "it was ended by signal 11"},
                                {"sleep 60", "timeout", "it went on beyond the time limit"},
                                {"sleep 0.4; exit 1", "timeout", "it gave up at the time limit"},
                                {"echo rubbish > $2", "invalid", "solution.txt:1:1: expected"},
                                {"mkfifo $2", "invalid", "solution.txt: no file that can be read"},
                                // The start alone, as the whole path.
                                {"{ echo 0 0; sed -n 2p $1; } > $2", "invalid", "ends: "},
                                // A solution that is there decides.
                                {"cp " + solution + " $2; exit 7", "solved", ""}};
    const std::string file = (folder / "b.json").string();
    Words options{"--time-limit", "0.3", "--json", file, "--table", "-"};
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const std::string label = "p" + std::to_string(i);
        options.insert(options.end(),
                       {"--planner", label + ": exec " + script(folder, label, ends[i].lines) +
                                         " {problem} {solution}"});
    }
    const Outcome outcome = bench({testcase_file("3ASV.txt")}, options);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json runs = json::parse(io::read_file(file))["runs"];
    ASSERT_EQ(runs.size(), 2 * ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const json& run = runs[2 * i];
        const std::string reason = run["reason"];
        EXPECT_EQ(run["status"], ends[i].status) << ends[i].lines;
        EXPECT_TRUE(reason.starts_with(ends[i].reason)) << reason;
        const std::string told = "p" + std::to_string(i) + ": " + ends[i].status + " (";
        EXPECT_NE(contains(outcome.out, told), ends[i].status == "solved") << outcome.out;
    }
    EXPECT_GT(runs.back()["cost_lower_bound"], 0);
    EXPECT_EQ(runs.back()["time_to_first_s"], runs.back()["time_total_s"]);
}

TEST(ExternalPlanner, NothingOfItIsLeft) {
    const TemporaryFolder folder;
    const std::string trace = (folder / "trace").string();
    const json run =
        run_of("echo $2 > " + trace + "; (sleep 2; echo late >> " + trace + ") & sleep 60");
    EXPECT_EQ(run["status"], "timeout");
    const std::string solution = lines_of(io::read_file(trace)).at(0);
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(solution).parent_path()));
    Surroundings killed;
    killed.signals = {SIGKILL};
    bench({testcase_file("3ASV.txt")},
          {"--planner", "exec " + script(folder, "s.sh", "echo $1 > " + trace + "; sleep 60") +
                            " {solution} {problem}"},
          killed);
    ::usleep(2'000'000);
    const auto left = lines_of(io::read_file(trace));
    ASSERT_EQ(left.size(), 1U) << "a process of its group went on";
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(left[0]).parent_path()));
}

TEST(ExternalPlanner, TheMemoryLimitHoldsForItToo) {
    if (sanitized) GTEST_SKIP() << "a sanitizer wants memory of its own";
    const TemporaryFolder folder;
    const std::string file = (folder / "b.json").string();
    // A grid of configurations of which only a part fits.
    const std::string command = std::string("it: exec ") + ASV_PROGRAM_DIR +
                                "/asv-solve {problem} {solution} --planner prm-grid --threads 1";
    const Outcome outcome = bench({testcase_file("7ASV.txt")},
                                  {"--memory-limit", "2", "--planner", command, "--json", file});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json report = json::parse(io::read_file(file));
    for (const json& run : report["runs"])
        EXPECT_EQ(run["status"], "memory-limit") << run["reason"];
}

/// Programs that catch the lack of memory and say so, whatever they held.
TEST(ExternalPlanner, MayTellItselfThatThereWasNoMemory) {
    const std::string lines = "echo 'MemoryError: no room' >&2; exit 1";
    EXPECT_EQ(run_of(lines)["status"], "crash") << "there was no limit";
    const json run = run_of(lines, {"--memory-limit", "500"});
    EXPECT_EQ(run["status"], "memory-limit");
    EXPECT_EQ(run["reason"], "it wanted more than 500 MB of memory");
}

TEST(ExternalPlanner, ACommandThatCannotBeRunIsWrongUsage) {
    const auto message = [](const std::string& planner) {
        const Outcome outcome = bench({testcase_file("3ASV.txt")}, {"--planner", planner});
        EXPECT_EQ(outcome.exit_code, 2) << planner;
        return outcome.err;
    };
    EXPECT_TRUE(contains(message("a: exec cp {problem} out"), "{solution} does not stand in it"));
    EXPECT_TRUE(contains(message("a: exec cp {solution} out"), "{problem} does not stand in it"));
    EXPECT_TRUE(
        contains(message("exec cp {problem} {solution} {speed}"), "no placeholder {speed}"));
    EXPECT_TRUE(contains(message("exec ./no-such {problem} {solution}"), "no program './no-such'"));
    EXPECT_TRUE(contains(message("exec cp '{problem} {solution}"), "a quote ' is not closed"));
}

/// A copy of asv-bench in the folder, by its way from the other programs.
std::string lone_bench(const TemporaryFolder& folder) {
    const std::filesystem::path lone = folder / "asv-bench";
    std::filesystem::copy_file(std::filesystem::path(ASV_PROGRAM_DIR) / "asv-bench", lone);
    return std::filesystem::relative(lone, ASV_PROGRAM_DIR).string();
}

/// As it is where asv-ompl is not built, and not installed beside it.
TEST(ExternalPlanner, OfOmplNeedsAsvOmplBesideIt) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program(
        lone_bench(folder), {testcase_file("3ASV.txt"), "--planner", "ompl:RRTConnect"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(contains(outcome.err, "this asv-bench was built without OMPL")) << outcome.err;
}

/// An asv-ompl that knows one planner, and finds no path.
TEST(ExternalPlanner, OfOmplIsACommandThatAsvOmplHasTaken) {
    const TemporaryFolder folder;
    const std::string program = lone_bench(folder), file = (folder / "b.json").string();
    const std::string ompl =
        script(folder, "asv-ompl",
               "case \"$*\" in *Magic*) exit 2;; *--check-planner*) exit 0;; esac; exit 4");
    const Outcome unknown =
        run_program(program, {testcase_file("3ASV.txt"), "--planner", "ompl:Magic"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_EQ(unknown.err, "asv-bench: --planner ompl:Magic: asv-ompl does not take it\n");
    const Outcome outcome =
        run_program(program, {testcase_file("3ASV.txt"), "--planner",
                              "far: ompl:RRTConnect range=1 --optimize=2", "--json", file});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json report = json::parse(io::read_file(file));
    EXPECT_EQ(report["planners"][0]["label"], "far");
    EXPECT_EQ(report["planners"][0]["command"],
              json({ompl, "{problem}", "{solution}", "--planner", "RRTConnect", "--set", "range=1",
                    "--optimize=2", "--seed", "{seed}", "--time-limit", "{time}", "--quiet"}));
    EXPECT_EQ(report["runs"][0]["status"], "infeasible") << report["runs"][0]["reason"];
}

TEST(ExternalPlanner, IsInTheFilesAndReadAgain) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    const std::string program = script(folder, "my planner.sh", "exit 0");
    ASSERT_EQ(bench({testcase_file("3ASV.txt")},
                    {"--planner", "a:b: exec '" + program + "' {problem} {solution} 'two words'",
                     "--direction", "both", "--json", in("a.json"), "--csv", in("a.csv"),
                     "--database", in("a.db"), "--ompl-log", in("a.log"), "--plot", in("a.svg")})
                  .exit_code,
              0);
    const json report = json::parse(io::read_file(in("a.json")));
    EXPECT_EQ(report["planners"][0]["label"], "a:b");
    EXPECT_EQ(report["planners"][0]["command"],
              json({program, "{problem}", "{solution}", "two words"}));
    EXPECT_EQ(report["runs"][2]["command"],
              "'" + program + "' reversed.txt solution.txt 'two words'");
    ASSERT_EQ(run_program("asv-bench",
                          {"--from", in("a.json"), "--json", in("b.json"), "--csv", in("b.csv")})
                  .exit_code,
              0);
    EXPECT_EQ(io::read_file(in("a.json")), io::read_file(in("b.json")));
    EXPECT_EQ(io::read_file(in("a.csv")), io::read_file(in("b.csv")));
}

}  // namespace
}  // namespace asv::test
