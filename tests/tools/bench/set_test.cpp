#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/bounds/feasibility.hpp"
#include "core/solve/solve.hpp"
#include "io/benchmark/record/generated_name.hpp"
#include "io/benchmark/set/benchmark_set.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"
#include "tests/tools/bench/bench_runs.hpp"
#include "tools/families/generator.hpp"

/// The problems of the benchmark set, and asv-bench --set.

namespace asv::test {
namespace {

using io::SetProblem;
using nlohmann::json;

core::Problem made_from(const SetProblem& entry) {
    return tools::generated(*io::generator_words(io::generated_name(entry.words))).problem;
}

/// The runs of one seed on the problems that the pattern fits.
json runs_on(const std::string& pattern, const Words& more = {}) {
    const TemporaryFolder folder;
    const std::string file = (folder / "b.json").string();
    Words options{"--set", pattern, "--seeds", "1", "--quiet", "--json", file};
    options.insert(options.end(), more.begin(), more.end());
    const Outcome outcome = run_program("asv-bench", options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(io::read_file(file))["runs"];
}

TEST(SetOfProblems, EveryLineMakesAProblemOfValidEnds) {
    for (const SetProblem& entry : io::benchmark_set()) {
        SCOPED_TRACE(entry.name);
        const core::Problem problem = made_from(entry);
        EXPECT_EQ(problem.asv_count(), entry.asv_count);
        EXPECT_TRUE(core::invalid_ends(problem).empty());
    }
}

/// No chain gets through a corridor that is longer than the chain and so low that the least area,
/// divided by the chain's length, is higher. In the first state in which all ASVs are beyond its
/// left mouth, the hindmost is beyond it by at most one step, so all are within the corridor: in
/// the strip between the blocks, or in one of twice the tolerance at a border. There the polygon is
/// at most as large as height times length: its turns add up to less than 4 pi, so it goes round no
/// point twice.
void expect_too_low(const core::Problem& problem) {
    const core::Requirements& r = problem.requirements;
    ASSERT_EQ(problem.obstacles.size(), 2U);
    const core::Box &below = problem.obstacles[0], &above = problem.obstacles[1];
    ASSERT_EQ(below.low.x, above.low.x);
    ASSERT_EQ(below.high.x, above.high.x);
    ASSERT_EQ(below.low.y, 0);
    ASSERT_EQ(above.high.y, 1);
    const double e = r.tolerance;
    const double chain = static_cast<double>(problem.asv_count() - 1) * (r.broom_length + e);
    const double length = below.high.x - below.low.x - 2 * e;
    const double height = above.low.y - below.high.y + 2 * e;
    EXPECT_GT(length, chain + r.max_step + e);
    EXPECT_LT(height * chain, r.min_area(problem.asv_count()) - e);
    EXPECT_LT(2 * e * chain, r.min_area(problem.asv_count()) - e);
    for (const core::Point& point : problem.start) EXPECT_LT(point.x, below.low.x);
    for (const core::Point& point : problem.goal) EXPECT_GT(point.x, below.high.x);
}

TEST(SetOfProblems, ThoseWithoutAPathHaveNone) {
    std::size_t found = 0;
    for (const SetProblem& entry : io::benchmark_set()) {
        if (entry.feasible) continue;
        SCOPED_TRACE(entry.name);
        ++found;
        const core::Problem problem = made_from(entry);
        EXPECT_TRUE(core::check_feasibility(problem).proven_infeasible());
        if (entry.name.ends_with("-low")) expect_too_low(problem);
    }
    EXPECT_EQ(found, 20U);
}

TEST(SetOfProblems, ThoseWithoutAPathAreNeverReportedSolved) {
    for (const char* pattern : {"*-turned", "*-fenced", "*-low"}) {
        const json runs = runs_on(pattern, {"--time-limit", "10", "--planner", "auto", "--planner",
                                            "rrt", "--direction", "both"});
        EXPECT_GE(runs.size(), 24U);
        for (const json& run : runs) {
            EXPECT_EQ(run["status"], "infeasible") << run["problem"];
            EXPECT_TRUE(run["cost"].is_null());
        }
    }
}

/// Every solution is checked by the validator before asv-bench tells of it.
TEST(SetOfProblems, ASampleIsSolvedAndCostsNoLessThanTheBound) {
    std::size_t solved = 0;
    for (const char* pattern :
         {"corridor-0[1-5]a", "bend-0[34]a", "gauntlet-0[35]a", "rooms-0[13]a", "maze-1[0-2]a",
          "spiral-0[3-5]a", "crossing-[13]2a", "clutter-5*"})
        for (const json& run : runs_on(pattern, {"--time-limit", "50"})) {
            SCOPED_TRACE(run["problem"]);
            ASSERT_EQ(run["status"], "solved");
            ++solved;
            const auto& set = io::benchmark_set();
            const auto entry = std::find_if(set.begin(), set.end(), [&](const SetProblem& problem) {
                return problem.name == run["problem"];
            });
            ASSERT_NE(entry, set.end());
            EXPECT_GE(run["cost"], *entry->lower_bound);
        }
    EXPECT_GE(solved, 15U);
}

TEST(SetOfProblems, ListsWhatIsChosenAndRunsNothing) {
    const Outcome all = run_program("asv-bench", {"--set", "--list"});
    EXPECT_EQ(all.exit_code, 0) << all.err;
    EXPECT_EQ(all.out, io::format_set(io::benchmark_set()));
    const Outcome some = run_program("asv-bench", {"--set", "spiral", "--list"});
    EXPECT_EQ(some.out, io::format_set(io::chosen_of_set("spiral")));
}

TEST(SetOfProblems, RunsBesideFilesUnderItsOwnNames) {
    const TemporaryFolder folder;
    const std::string file = (folder / "b.json").string();
    ASSERT_EQ(bench({"x: generate: maze -n 8"}, {"--set", "clutter-03a", "--json", file}).exit_code,
              0);
    const json problems = json::parse(io::read_file(file))["problems"];
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[1]["name"], "clutter-03a");
    EXPECT_EQ(problems[1]["file"], "generate: " + io::chosen_of_set("clutter-03a")[0].words);
}

/// tests/benchmark/benchmark_set.py, in a folder of its own.
TEST(SetOfProblems, AScriptMakesTheFileAnewAndTakesBetterCosts) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const fs::path file = folder / "testcases/set/problems.csv";
    const std::string script = (folder / "tests/benchmark/benchmark_set.py").string();
    fs::create_directories(file.parent_path());
    fs::create_directories(fs::path(script).parent_path());
    const fs::path tree = ASV_SOURCE_DIR;
    fs::copy_file(tree / "testcases/set/problems.csv", file);
    fs::copy_file(tree / "tests/benchmark/benchmark_set.py", script);
    const auto run = [&](const Words& words) { return run_program(script, words); };
    if (run({"make"}).exit_code == cannot_start) GTEST_SKIP() << "no Python";
    EXPECT_EQ(io::read_file(file), io::format_set(io::benchmark_set()));

    SetProblem entry = io::chosen_of_set("crossing-03a").at(0);
    std::string text = io::read_file(file);
    const std::string worse = entry.name + ',' + entry.words + ",3,feasible,999.000000,0.001000";
    text.replace(text.find(entry.line), entry.line.size(), worse);
    std::ofstream(file) << text;
    ASSERT_EQ(bench({}, {"--set", entry.name, "--json", (folder / "b.json").string()}).exit_code,
              0);
    ASSERT_EQ(run({"make"}).exit_code, 0);
    EXPECT_EQ(io::read_file(file), text) << "what is known stays with the words";
    const Outcome updated = run({"update", (folder / "b.json").string()});
    ASSERT_EQ(updated.exit_code, 0) << updated.err;
    const auto set = io::parse_set(io::read_file(file));
    const auto found = std::find_if(set.begin(), set.end(), [&](const SetProblem& problem) {
        return problem.name == entry.name;
    });
    ASSERT_NE(found, set.end());
    EXPECT_LT(*found->best_cost, 999);
    EXPECT_EQ(*found->lower_bound, *entry.lower_bound);
    EXPECT_GE(*found->best_cost, *found->lower_bound);
    const Outcome results = run({"results", (folder / "b.json").string()});
    EXPECT_TRUE(contains(results.out, "| auto | 2 | 2 | 2 |")) << results.out << results.err;
}

TEST(SetOfProblems, WrongUsageIsTold) {
    const std::vector<std::pair<Words, std::string>> cases{
        {{"--set", "labyrinth"}, "--set labyrinth: no problem or family of the set is called that"},
        {{"--set", ""}, "no problem or family"},
        {{"--list"}, "--list requires --set"},
        {{"--set", "maze", "--from", "a.json"}, "--set excludes --from"}};
    for (const auto& [arguments, message] : cases) {
        const Outcome outcome = run_program("asv-bench", arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_TRUE(contains(outcome.err, message)) << outcome.err;
    }
}

}  // namespace
}  // namespace asv::test
