#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/tools/bench/bench_runs.hpp"

/// What a user of asv-bench sees.

namespace asv::test {
namespace {

using nlohmann::json;

json runs_of(const Words& problems, const Words& options) {
    const TemporaryFolder folder;
    const std::string file = (folder / "b.json").string();
    Words all = options;
    all.insert(all.end(), {"--json", file});
    const Outcome outcome = bench(problems, all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(io::read_file(file));
}

const Words two_planners{"--planner", "auto", "--planner", "swaps: rrt-connect swap-limiter=on"};

TEST(BenchProgram, PrintsATableForEachProblemAndDirection) {
    Words options = two_planners;
    options.insert(options.end(), {"--direction", "both"});
    const Outcome outcome =
        bench({testcase_file("3ASV.txt"), testcase_file("3ASV-x4.txt")}, options);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (const char* part : {"### 3ASV, forward\n", "### 3ASV-x4, reversed\n", "| auto | 2 of 2 |",
                             "| swaps | 2 of 2 |", "10^6 scalar state checks"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << outcome.out;
}

TEST(BenchProgram, SameSeedsSameWork) {
    const auto all = [] { return runs_of({testcase_file("3ASV.txt")}, two_planners)["runs"]; };
    const json first = all(), again = all();
    ASSERT_EQ(first.size(), 4U);
    for (std::size_t i = 0; i < first.size(); ++i)
        EXPECT_EQ(without_times(first[i]), without_times(again[i]));
}

/// The planner's settings, the direction and the seed of a run, as asv-solve takes them.
TEST(BenchProgram, ARunIsThatOfAsvSolve) {
    const TemporaryFolder folder;
    const json report = runs_of({testcase_file("3ASV.txt")},
                                {"--planner", "swaps: rrt-connect swap-limiter=on", "--direction",
                                 "reversed", "--optimize", "0.05", "--first-seed", "4"});
    for (const json& run : report["runs"]) {
        std::istringstream words(run["command"].get<std::string>());
        Words arguments;
        for (std::string word; words >> word;) arguments.push_back(word);
        ASSERT_EQ(arguments.at(0), "asv-solve");
        arguments.erase(arguments.begin());
        arguments.at(1) = (folder / "s.txt").string();
        arguments.insert(arguments.end(), {"--quiet", "--stats", (folder / "s.json").string()});
        ASSERT_EQ(run_program("asv-solve", arguments).exit_code, 0);
        const json stats = json::parse(io::read_file(folder / "s.json"));
        for (const char* key :
             {"seed", "status", "cost_first", "cost_of_search", "cost", "cost_lower_bound",
              "primitive_steps", "primitive_steps_lower_bound", "tree_nodes", "iterations",
              "state_checks", "edge_checks"})
            EXPECT_EQ(run[key], stats[key]) << key;
    }
}

TEST(BenchProgram, TakesScenarios) {
    const json report = runs_of({testcase_file("bodies/arm-3-workshop.json")},
                                {"--planner", "rrt-connect", "--direction", "both"});
    EXPECT_EQ(report["problems"][0]["name"], "arm-3-workshop");
    ASSERT_EQ(report["runs"].size(), 4U);
    for (const json& run : report["runs"]) EXPECT_EQ(run["status"], "solved");
}

TEST(BenchProgram, WritesEveryFileAndNothingElse) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    const Outcome outcome =
        bench({testcase_file("3ASV.txt"), testcase_file("3ASV-x4.txt")},
              {"--table",          in("b.md"),   "--csv",     in("b.csv"),   "--json",
               in("b.json"),       "--database", in("b.db"),  "--ompl-log",  in("b.log"),
               "--plot",           in("b.svg"),  "--plot",    in("b.png"),   "--profile",
               in("p.svg"),        "--anytime",  in("a.pdf"), "--parameter", "obstacles",
               "--parameter-plot", in("o.svg")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.entries(), 11);
    for (const char* name : {"b.md", "b.csv", "b.json", "b.db", "b-3ASV.log", "b-3ASV-x4.log",
                             "b.svg", "b.png", "p.svg", "a.pdf", "o.svg"})
        EXPECT_GT(std::filesystem::file_size(folder / name), 100U) << name;
}

TEST(BenchProgram, WritesAPageOrSaysThatItCannot) {
    const TemporaryFolder folder;
    const std::string file = (folder / "b.html").string();
    const Outcome outcome = bench({testcase_file("3ASV.txt")}, {"--report", file});
    if (outcome.exit_code == 2) {
        EXPECT_NE(outcome.err.find("built without charts"), std::string::npos) << outcome.err;
        EXPECT_EQ(folder.entries(), 0);
        return;
    }
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(io::read_file(file).find("<title>Benchmark: 1 planner on 1 problem</title>"),
              std::string::npos);
}

/// What asv-generate has written beside the problem, kept in the file of the runs.
TEST(BenchProgram, DrawsCurvesOverAParameterOfTheGenerator) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    for (const char* height : {"2", "3"})
        ASSERT_EQ(run_program("asv-generate", {"corridor", "-n", "3", "--height-factor", height,
                                               "--solvable", "--quiet", "-o", in(height)})
                      .exit_code,
                  0);
    ASSERT_EQ(bench({in("2"), in("3")}, {"--parameter", "height-factor", "--json", in("b.json")})
                  .exit_code,
              0);
    EXPECT_EQ(
        json::parse(io::read_file(in("b.json")))["problems"][1]["parameters"]["height-factor"], 3);
    EXPECT_EQ(run_program("asv-bench", {"--from", in("b.json"), "--parameter", "height-factor",
                                        "--parameter-plot", in("h.svg")})
                  .exit_code,
              0);
    EXPECT_NE(io::read_file(in("h.svg")).find("Over height-factor"), std::string::npos);
    const Outcome none = run_program("asv-bench", {"--from", in("b.json"), "--parameter", "magic"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_NE(none.err.find("--parameter magic: 2 has no such number"), std::string::npos)
        << none.err;
}

TEST(BenchProgram, WritesTablesForPrint) {
    const TemporaryFolder folder;
    const std::string file = (folder / "b.tex").string();
    Words options = two_planners;
    options.insert(options.end(), {"--table", file, "--columns", "rate,par2-ms"});
    ASSERT_EQ(bench({testcase_file("3ASV.txt")}, options).exit_code, 0);
    const std::string table = io::read_file(file);
    EXPECT_NE(table.find("  planner & rate \\% (95 \\% CI) & PAR-2 ms \\\\\n"), std::string::npos)
        << table;
}

TEST(BenchProgram, AnUnsolvedRunIsReportedAndNoError) {
    const Outcome outcome =
        bench({testcase_file("infeasible/wall-across.txt")}, {"--time-limit", "0.05"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("| wall-across | 0 of 2 | 0 (0, 84.19) | >50.00 (>50.00, >50.00) |"),
              std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("- wall-across forward, auto: timeout (no path found"),
              std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("seeds 1, 2\n"), std::string::npos) << outcome.out;
}

TEST(BenchProgram, EveryUnusableProblemIsToldBeforeAnythingRuns) {
    const TemporaryFolder folder;
    const Outcome outcome = bench(
        {testcase_file("3ASV.txt"), "no-such-file.txt", testcase_file("invalid/asv-count-zero.txt"),
         testcase_file("invalid/start-broom-crosses-obstacle.txt")},
        {"--csv", (folder / "b.csv").string()});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.out, "");
    for (const char* part :
         {"no-such-file.txt: ", "asv-count-zero.txt:1:", ".txt:2: start is not valid: broom"})
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.entries(), 0);
}

TEST(BenchProgram, WrongUsageNamesWhatThereIs) {
    const std::vector<std::pair<Words, std::string>> cases{
        {{"--planner", "magic"}, "rrt-connect"},
        {{"--planner", "auto magic=1"}, "pull-share"},
        {{"--planner", "auto pull-share=2"}, "from 0 to 1"},
        {{"--planner", "auto pull-share"}, "[LABEL:] NAME [KEY=VALUE]"},
        {{"--planner", "auto", "--planner", "auto"}, "two planners are called 'auto'"},
        {{"--planner", "rrt sampler=mix"}, "mix-uniform=1"},
        {{"--plot", "b.gif"}, "must end in .svg, .png or .pdf"},
        {{"--columns", "solved,magic"}, "there is no column 'magic'; there are solved, rate"},
        {{"--direction", "sideways"}, "forward"},
        {{"--layout", "round"}, "wide,column"},
        {{"--parameter-plot", "b.svg"}, "--parameter-plot wants --parameter NAME"},
        {{"--seeds", "0"}, "--seeds"},
        {{"--time-limit", "nan"}, "'nan' is not a decimal number"}};
    for (const auto& [options, message] : cases) {
        Words arguments{testcase_file("3ASV.txt")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = run_program("asv-bench", arguments);
        EXPECT_EQ(outcome.exit_code, 2) << options[1];
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    }
}

TEST(BenchProgram, WarnsOfSettingsWithoutEffect) {
    const Words words{testcase_file("bodies/point-town.json"), "--seeds", "1", "--planner",
                      "it: rrt-connect swap-step=0.1 sigma=0.1"};
    const Outcome outcome = run_program("asv-bench", words);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(
        outcome.err,
        "asv-bench: warning: it on point-town: swap-step=0.1 has no effect: swap-limiter is "
        "off\nasv-bench: warning: it on point-town: sigma=0.1 has no effect: the sampler that "
        "is chosen does not use it\n");
}

TEST(BenchProgram, SeveralLogsDoNotGoToStandardOutput) {
    const Outcome outcome =
        bench({testcase_file("3ASV.txt")}, {"--direction", "both", "--ompl-log", "-"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err,
              "asv-bench: --ompl-log - holds one problem in one direction, not several\n");
    EXPECT_TRUE(
        bench({testcase_file("3ASV.txt")}, {"--ompl-log", "-"}).out.starts_with("ASV version "));
}

TEST(BenchProgram, AnOutputThatCannotBeWrittenIsToldBeforeAnythingRuns) {
    for (const char* option : {"--table", "--csv", "--json", "--database", "--ompl-log", "--plot",
                               "--profile", "--anytime"}) {
        const Outcome outcome =
            bench({testcase_file("3ASV.txt")}, {option, "/no/such/folder/b.svg"});
        EXPECT_EQ(outcome.exit_code, 5) << option;
        EXPECT_EQ(outcome.out, "");
    }
}

TEST(BenchProgram, ProblemsOfOneNameKeepTheirFolders) {
    const TemporaryFolder folder;
    const std::string copy = (folder / "3ASV.txt").string();
    std::filesystem::copy_file(testcase_file("3ASV.txt"), copy);
    const json report = runs_of({testcase_file("3ASV.txt"), copy}, {});
    EXPECT_EQ(report["problems"][1]["name"], copy);
    EXPECT_EQ(bench({copy, copy}).exit_code, 2);
}

TEST(BenchProgram, AllStandsForEveryPlanner) {
    const json report = runs_of({testcase_file("bodies/arm-1-plane.json")}, {"--planner", "all"});
    EXPECT_EQ(report["planners"].size(), 8U);
    EXPECT_EQ(report["runs"].size(), 16U);
}

}  // namespace
}  // namespace asv::test
