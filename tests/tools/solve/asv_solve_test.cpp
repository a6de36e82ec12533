#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"
#include "geometry/simd/instruction_set.hpp"
#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/solution/trees_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"

/// What a user of asv-solve sees, and that every problem of ours is solved.

namespace asv::test {
namespace {

using Words = std::vector<std::string>;

Outcome solve(const std::string& problem, const std::string& solution, const Words& options = {}) {
    Words arguments{problem, solution, "--threads", "1", "--quiet"};
    if (std::find(options.begin(), options.end(), "--optimize") == options.end())
        arguments.insert(arguments.end(), {"--optimize", "0"});
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program("asv-solve", arguments);
}

Words solvable_testcases() {
    Words names;
    for (const auto& entry : std::filesystem::directory_iterator(testcase_file("")))
        if (entry.path().extension() == ".txt") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// GoogleTest wants names of letters and digits.
std::string identifier(const testing::TestParamInfo<std::string>& tested) {
    std::string name;
    for (const char c : tested.param) name += std::isalnum(c) != 0 ? c : '_';
    return name;
}

class EverySolvableTestCase : public testing::TestWithParam<std::string> {};

TEST_P(EverySolvableTestCase, IsSolvedWithAContinuouslyValidPath) {
    const TemporaryFolder folder;
    const std::string solution = (folder / "s").string();
    for (const std::string seed : {"1", "2", "3"}) {
        const Outcome outcome =
            solve(testcase_file(GetParam() + ".txt"), solution, {"--seed", seed});
        ASSERT_EQ(outcome.exit_code, 0) << "seed " << seed << ": " << outcome.err;
        const auto problem = io::read_problem(testcase_file(GetParam() + ".txt")).problem;
        const auto path = io::read_solution(solution, problem.asv_count());
        EXPECT_TRUE(core::validate(problem, path, {.continuous = true}).valid()) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Ours, EverySolvableTestCase, testing::ValuesIn(solvable_testcases()),
                         identifier);

/// The bidirectional RRT for ASVs with all of its parts, on what it solves in time.
class MethodA : public testing::TestWithParam<std::string> {};

TEST_P(MethodA, SolvesIt) {
    const TemporaryFolder folder;
    const std::string solution = (folder / "s").string();
    const Outcome outcome =
        solve(testcase_file(GetParam() + ".txt"), solution, {"--planner", "rrt-connect"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Outcome verdict =
        run_program("asv-validate", {testcase_file(GetParam() + ".txt"), solution, "--continuous"});
    EXPECT_EQ(verdict.exit_code, 0) << verdict.out;
}

INSTANTIATE_TEST_SUITE_P(Ours, MethodA,
                         testing::Values("3ASV", "3ASV-x4", "7ASV-x6", "3ASV-clutter-20"),
                         identifier);

/// Every planner by its name, with the file of its tree or roadmap.
class EveryPlanner : public testing::TestWithParam<std::string> {};

TEST_P(EveryPlanner, SolvesAnEasyOne) {
    const TemporaryFolder folder;
    const std::string solution = (folder / "s").string(), trees = (folder / "t").string();
    const Outcome outcome =
        solve(testcase_file("3ASV.txt"), solution, {"--planner", GetParam(), "--trees", trees});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Outcome verdict =
        run_program("asv-validate", {testcase_file("3ASV.txt"), solution, "--continuous"});
    EXPECT_EQ(verdict.exit_code, 0) << verdict.out;
    const io::SearchTrees drawn = io::read_trees(trees);
    EXPECT_EQ(drawn.planner, GetParam());
    ASSERT_FALSE(drawn.trees.empty());
    const bool roadmap = GetParam().starts_with("prm");
    EXPECT_EQ(drawn.trees[0].root, roadmap ? "roadmap" : "start");
    EXPECT_EQ(drawn.edges.empty(), !roadmap);
}

Words all_planners() {
    const auto names = core::planner_names();
    return {names.begin(), names.end()};
}

INSTANTIATE_TEST_SUITE_P(Ours, EveryPlanner, testing::ValuesIn(all_planners()), identifier);

TEST(AsvSolve, EveryInstructionSetGivesTheSameBytes) {
    const TemporaryFolder folder;
    std::string expected;
    for (const std::string& name : geometry::simd::instruction_sets()) {
        const std::string out = folder / (name + ".txt");
        const Outcome run = run_program(
            "asv-solve", {testcase_file("3ASV.txt"), out, "--threads", "1", "--optimize", "0.02"},
            {.environment = {"ASV_SIMD=" + name}});
        ASSERT_EQ(run.exit_code, 0) << name << ": " << run.err;
        if (expected.empty()) expected = io::read_file(out);
        EXPECT_EQ(io::read_file(out), expected) << name;
    }
}

TEST(AsvSolve, AnUnknownInstructionSetIsWrongUsage) {
    const TemporaryFolder folder;
    const std::string out = folder / "out.txt";
    const Outcome run = run_program("asv-solve", {testcase_file("3ASV.txt"), out},
                                    {.environment = {"ASV_SIMD=MMX"}});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("ASV_SIMD: no instruction set 'MMX'"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(geometry::simd::instruction_sets().back()), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(SolveProgram, ListsEveryPlannerWithItsSettingsAndSource) {
    const Outcome outcome = run_program("asv-solve", {"--list-planners"});
    EXPECT_EQ(outcome.exit_code, 0);
    for (const std::string& planner : all_planners()) {
        EXPECT_NE(outcome.out.find(planner + ": "), std::string::npos) << planner;
        EXPECT_NE(outcome.out.find(core::planner_source(planner)), std::string::npos) << planner;
    }
    EXPECT_NE(outcome.out.find("one of dijkstra, a-star; default a-star"), std::string::npos);
}

TEST(SolveProgram, ThePageOfSettingsIsWhatItPrints) {
    const Outcome outcome = run_program("asv-solve", {"--list-planners", "--markdown"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, io::read_file(std::string(ASV_SOURCE_DIR) + "/docs/settings.md"))
        << "make the page anew: asv-solve --list-planners --markdown > docs/settings.md";
    EXPECT_EQ(run_program("asv-solve", {"--markdown"}).exit_code, 2);
}

TEST(SolveProgram, SameSeedSameBytesOtherSeedOtherPath) {
    const TemporaryFolder folder;
    const auto bytes = [&](const std::string& seed, const std::string& name) {
        const std::string file = (folder / name).string();
        EXPECT_EQ(solve(testcase_file("7ASV-x6.txt"), file, {"--seed", seed, "--optimize", "0.05"})
                      .exit_code,
                  0);
        return io::read_file(file);
    };
    const std::string first = bytes("5", "a");
    EXPECT_EQ(first, bytes("5", "b"));
    EXPECT_NE(first, bytes("6", "c"));
}

TEST(SolveProgram, ReversedPlanStillLeadsFromStartToGoal) {
    const TemporaryFolder folder;
    const std::string file = (folder / "s").string();
    ASSERT_EQ(solve(testcase_file("3ASV.txt"), file, {"--reverse"}).exit_code, 0);
    EXPECT_EQ(run_program("asv-validate", {testcase_file("3ASV.txt"), file}).exit_code, 0);
}

TEST(SolveProgram, StatisticsAndTreesAgreeWithTheSolution) {
    const TemporaryFolder folder;
    const std::string file = (folder / "s").string(), stats = (folder / "j").string(),
                      trees = (folder / "t").string();
    ASSERT_EQ(
        solve(testcase_file("3ASV.txt"), file, {"--stats", stats, "--trees", trees}).exit_code, 0);
    const auto json = nlohmann::json::parse(io::read_file(stats));
    const auto solution = io::read_solution(file, 3);
    EXPECT_EQ(json["problem"], "3ASV.txt");
    EXPECT_EQ(json["status"], "solved");
    EXPECT_EQ(json["asv_count"], 3);
    EXPECT_EQ(json["primitive_steps"], solution.path.size() - 1);
    EXPECT_NEAR(json["cost"].get<double>(), solution.cost, 1e-9);
    EXPECT_LE(json["cost_lower_bound"].get<double>(), solution.cost);
    EXPECT_GT(json["cost_lower_bound"].get<double>(), 0);
    const auto drawn = nlohmann::json::parse(io::read_file(trees));
    for (const std::size_t side : {0U, 1U})
        EXPECT_EQ(drawn["trees"][side]["points"].size(), json["tree_nodes"][side]);
}

class EveryInfeasibleTestCase : public testing::TestWithParam<std::string> {};

TEST_P(EveryInfeasibleTestCase, IsRefusedWithAReasonAndNoFile) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program(
        "asv-solve", {testcase_file("infeasible/" + GetParam() + ".txt"), (folder / "s").string()});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find("infeasible"), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.entries(), 0);
}

INSTANTIATE_TEST_SUITE_P(Ours, EveryInfeasibleTestCase,
                         testing::Values("enclosed-goal", "enclosed-start", "opposite-orientation",
                                         "two-asvs", "wall-across"),
                         identifier);

TEST(SolveProgram, ASinglePointGoesRoundTheObstacle) {
    const TemporaryFolder folder;
    const std::string problem = (folder / "p").string(), file = (folder / "s").string();
    io::write_file(problem, "1\n0.1 0.1\n0.9 0.1\n1\n0.4 0 0.6 0 0.6 0.5 0.4 0.5\n");
    ASSERT_EQ(solve(problem, file).exit_code, 0);
    const auto solution = io::read_solution(file, 1);
    for (std::size_t i = 0; i < solution.path.size(); ++i) {
        const auto at = solution.path.state(i)[0];
        EXPECT_FALSE(at.x > 0.4 && at.x < 0.6 && at.y < 0.5) << "state " << i;
    }
    // Up to one corner, along the top, down from the other.
    EXPECT_NEAR(solution.cost, 0.2 + 2 * 0.5, 0.02);
}

TEST(SolveProgram, ASinglePointThatIsWalledInGoesStraightAhead) {
    const TemporaryFolder folder;
    const std::string problem = (folder / "p").string(), file = (folder / "s").string();
    for (const std::string start : {"0.1 0.5", "0.5 0.5"}) {
        io::write_file(problem, "1\n" + start + "\n0.9 0.5\n1\n0.4 0 0.6 0 0.6 1 0.4 1\n");
        ASSERT_EQ(solve(problem, file).exit_code, 0) << start;
        EXPECT_EQ(run_program("asv-validate", {problem, file, "--continuous"}).exit_code, 0);
    }
}

/// A point among so many small boxes that reading them alone takes longer than the limit below.
std::string dusty_problem() {
    std::string text = "1\n0.0005 0.0005\n0.9995 0.9995\n90000\n";
    for (int i = 0; i < 300; ++i) {
        for (int j = 0; j < 300; ++j) {
            const std::string x = std::to_string((i + 0.4) / 300),
                              y = std::to_string((j + 0.4) / 300);
            const std::string right = std::to_string((i + 0.6) / 300);
            const std::string top = std::to_string((j + 0.6) / 300);
            text += x + ' ' + y + ' ' + right + ' ' + y + ' ' + right + ' ' + top + ' ' + x + ' ' +
                    top + '\n';
        }
    }
    return text;
}

TEST(SolveProgram, ATimeLimitEndsEvenTheReading) {
    const TemporaryFolder folder;
    const std::string problem = (folder / "p").string(), stats = (folder / "j").string();
    io::write_file(problem, dusty_problem());
    const Outcome outcome =
        run_program("asv-solve", {problem, (folder / "s").string(), "--threads", "1",
                                  "--time-limit", "0.001", "--stats", stats});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("timeout after"), std::string::npos) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(io::read_file(stats))["status"], "timeout");
    EXPECT_EQ(folder.entries(), 2) << "no solution";
}

TEST(SolveProgram, WrongUsageNamesWhatThereIs) {
    const TemporaryFolder folder;
    const std::string file = (folder / "s").string();
    const Outcome planner = solve(testcase_file("3ASV.txt"), file, {"--planner", "magic"});
    EXPECT_EQ(planner.exit_code, 2);
    EXPECT_NE(planner.err.find("rrt-connect"), std::string::npos) << planner.err;
    const Outcome unknown = solve(testcase_file("3ASV.txt"), file, {"--set", "magic=1"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("pull-share"), std::string::npos) << unknown.err;
    const Outcome range = solve(testcase_file("3ASV.txt"), file, {"--set", "pull-share=2"});
    EXPECT_EQ(range.exit_code, 2);
    EXPECT_NE(range.err.find("from 0 to 1"), std::string::npos) << range.err;
    const Outcome no_value = solve(testcase_file("3ASV.txt"), file, {"--set", "pull-share"});
    EXPECT_EQ(no_value.exit_code, 2);
    EXPECT_EQ(no_value.err, "asv-solve: --set wants KEY=VALUE, not 'pull-share'\n");
    const Outcome mix =
        solve(testcase_file("3ASV.txt"), file, {"--planner", "rrt", "--set", "sampler=mix"});
    EXPECT_EQ(mix.exit_code, 2);
    EXPECT_NE(mix.err.find("mix-uniform=1"), std::string::npos) << mix.err;
    EXPECT_EQ(folder.entries(), 0);
}

TEST(SolveProgram, InvalidStartIsNamedWithItsLine) {
    const TemporaryFolder folder;
    const Outcome outcome =
        solve(testcase_file("invalid/start-broom-crosses-obstacle.txt"), (folder / "s").string());
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find(".txt:2: start is not valid: broom"), std::string::npos)
        << outcome.err;
}

}  // namespace
}  // namespace asv::test
