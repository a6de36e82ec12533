#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"

/// Scenarios of arms and points through all programs.

namespace asv {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenarios() {
    std::vector<std::string> names;
    for (const char* folder : {"bodies", "worlds"})
        for (const auto& entry : fs::directory_iterator(test::testcase_file(folder)))
            if (entry.path().extension() == ".json") names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    return names;
}

struct EveryScenario : testing::TestWithParam<std::string> {
    test::TemporaryFolder folder;
};

std::string test_name(const testing::TestParamInfo<std::string>& scenario) {
    std::string name = fs::path(scenario.param).stem().string();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Ours, EveryScenario, testing::ValuesIn(scenarios()), test_name);

TEST_P(EveryScenario, IsSolvedValidatedAndShown) {
    const std::string solution = folder / "s.txt", again = folder / "t.txt",
                      trees = folder / "trees.json", stats = folder / "stats.json";
    const std::vector<std::string> options{"--threads", "1", "--optimize", "0.05", "--quiet"};
    for (const std::string& file : {solution, again}) {
        std::vector<std::string> arguments{GetParam(), file, "--trees", trees, "--stats", stats};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const test::Outcome solved = test::run_program("asv-solve", arguments);
        ASSERT_EQ(solved.exit_code, 0) << solved.err;
    }
    EXPECT_EQ(io::read_file(solution), io::read_file(again));
    const test::Outcome validated =
        test::run_program("asv-validate", {GetParam(), solution, "--continuous"});
    EXPECT_EQ(validated.exit_code, 0) << validated.out;
    EXPECT_EQ(test::run_program("asv-validate", {GetParam()}).exit_code, 0);
    const std::string svg = folder / "p.svg", page = folder / "p.html";
    const test::Outcome viewed = test::run_program(
        "asv-view",
        {GetParam(), solution, "--trees", trees, "--stats", stats, "-o", svg, "-o", page});
    EXPECT_EQ(viewed.exit_code, 0) << viewed.err;
    EXPECT_GT(fs::file_size(svg), 1000U);
}

TEST(Worlds, SuitChainsOfOtherLengths) {
    const test::TemporaryFolder folder;
    fs::copy(test::testcase_file("worlds"), folder.path());
    for (const char* world : {"harbour", "islands", "river", "floor"}) {
        for (const int asv_count : {3, 10}) {
            const std::string file = folder / (std::string(world) + ".json");
            nlohmann::json scenario = nlohmann::json::parse(io::read_file(file));
            scenario["body"]["asv_count"] = asv_count;
            io::write_file(file, scenario.dump());
            const std::string solution = folder / "s.txt";
            const test::Outcome solved =
                test::run_program("asv-solve", {file, solution, "--optimize", "0"});
            EXPECT_EQ(solved.exit_code, 0) << world << ", " << asv_count << ": " << solved.err;
            EXPECT_EQ(test::run_program("asv-validate", {file, solution, "--continuous"}).exit_code,
                      0);
        }
    }
}

TEST(ScenarioProgram, AScenarioIsJudgedByItsOwnTolerance) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "s.json", picture = folder / "p.svg";
    // The brooms are longer than they should be by 0.01.
    std::ofstream(file) << R"({"version": 1, "body": {"kind": "chain", "broom_length": 1},
 "bounds": null, "tolerance": 0.02,
 "start": [[0, 0], [1.01, 0], [1.01, 1.01]], "goal": [[5, 0], [6.01, 0], [6.01, 1.01]]})";
    EXPECT_EQ(test::run_program("asv-validate", {file}).exit_code, 0);
    EXPECT_EQ(test::run_program("asv-validate", {file, "--tolerance", "1e-5"}).exit_code, 1);
    ASSERT_EQ(test::run_program("asv-view", {file, "-o", picture}).exit_code, 0);
    EXPECT_NE(io::read_file(picture).find("start and goal are valid"), std::string::npos);
}

TEST(ScenarioProgram, AMistakeEndsWith3AndItsPlace) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "s.json";
    std::ofstream(file)
        << "{\"version\": 1, \"body\": {\"kind\": \"point\"},\n \"start\": [0.5, 0.5],\n"
           " \"goal\": [0.9, 0.9, 1]}\n";
    for (const char* program : {"asv-solve", "asv-validate"}) {
        std::vector<std::string> arguments{file};
        if (std::string(program) == "asv-solve") arguments.push_back(folder / "out.txt");
        const test::Outcome outcome = test::run_program(program, arguments);
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_NE(outcome.err.find(file + ":3:10: expected a point [x, y] at goal"),
                  std::string::npos)
            << outcome.err;
    }
}

TEST(ScenarioProgram, AnInvalidEndIsToldWithItsLine) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "s.json";
    std::ofstream(file) << "{\"version\": 1, \"body\": {\"kind\": \"point\"},\n"
                           " \"obstacles\": [[[0.4, 0.4], [0.6, 0.6]]],\n \"start\": [0.1, 0.1],\n"
                           " \"goal\": [0.5, 0.5]}\n";
    const test::Outcome outcome = test::run_program("asv-solve", {file, folder / "out.txt"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find(file + ":4: goal is not valid: the point meets obstacle 1"),
              std::string::npos)
        << outcome.err;
}

TEST(Scenarios, WarnsOfASettingWithoutEffectUnlessQuietIsAskedFor) {
    const test::TemporaryFolder folder;
    std::vector<std::string> words{test::testcase_file("bodies/point-town.json"),
                                   (folder / "s").string()};
    words.insert(words.end(), {"--planner", "rrt", "--set", "sigma=0.1", "--optimize", "0"});
    const test::Outcome outcome = test::run_program("asv-solve", words);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(
        outcome.err.find("asv-solve: warning: --set sigma=0.1 has no effect: the sampler that "
                         "is chosen does not use it\n"),
        0U)
        << outcome.err;
    words.emplace_back("--quiet");
    EXPECT_EQ(test::run_program("asv-solve", words).err, "");
}

}  // namespace
}  // namespace asv
