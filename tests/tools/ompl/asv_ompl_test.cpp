#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/problem/scenario_text.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"
#include "tests/tools/bench/bench_runs.hpp"
#include "tests/tools/ompl/ompl_samples.hpp"

/// The program, and OMPL's planners in asv-bench.

namespace asv::test {
namespace {

using nlohmann::json;

TEST(AsvOmpl, TheSameSeedGivesTheSameFile) {
    const TemporaryFolder folder;
    std::vector<std::string> texts;
    for (const std::string seed : {"5", "5", "6"}) {
        const std::string file = (folder / "s.txt").string();
        const Outcome outcome =
            run_program("asv-ompl", {testcase_file("3ASV.txt"), file, "--seed", seed, "--planner",
                                     "RRTConnect", "--set", "range=0.4"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(contains(outcome.err, "solved: cost ")) << outcome.err;
        texts.push_back(io::read_file(file));
        const Outcome verdict =
            run_program("asv-validate", {testcase_file("3ASV.txt"), file, "--continuous"});
        EXPECT_EQ(verdict.exit_code, 0) << verdict.out;
    }
    EXPECT_EQ(texts[0], texts[1]);
    EXPECT_NE(texts[0], texts[2]);
}

TEST(AsvOmpl, WrongUseIsToldApart) {
    const TemporaryFolder folder;
    const std::string problem = testcase_file("3ASV.txt"), file = (folder / "s.txt").string();
    const auto run = [&](const Words& more) {
        Words words{problem, file};
        words.insert(words.end(), more.begin(), more.end());
        return run_program("asv-ompl", words);
    };
    EXPECT_EQ(run({"--planner", "A*"}).exit_code, 2);
    EXPECT_EQ(run({"--set", "rnage=1"}).exit_code, 2);
    EXPECT_EQ(run({"--set", "range"}).exit_code, 2);
    EXPECT_EQ(run_program("asv-ompl", {problem}).exit_code, 2);
    EXPECT_EQ(run_program("asv-ompl", {problem, problem}).exit_code, 2);
    EXPECT_EQ(run({"--time-limit", "0"}).exit_code, 1);
    EXPECT_EQ(run_program("asv-ompl", {(folder / "none").string(), file}).exit_code, 3);
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_TRUE(contains(run_program("asv-ompl", {"--list-planners"}).out, "BITstar\n"));
}

TEST(AsvOmpl, SampledMotionsGoThroughAThinWallAndAreToldSo) {
    const TemporaryFolder folder;
    const std::string problem = (folder / "wall.json").string();
    const std::string file = (folder / "s.txt").string(), runs = (folder / "b.json").string();
    io::write_file(problem, io::format_scenario(before_a_thin_wall()));
    const Outcome sampled =
        run_program("asv-ompl", {problem, file, "--motion", "sampled", "--set", "range=2"});
    EXPECT_EQ(sampled.exit_code, 1) << sampled.err;
    EXPECT_TRUE(contains(sampled.err, "not valid: collisions")) << sampled.err;

    const Outcome outcome =
        bench({problem}, {"--planner", "certified: ompl:RRTConnect range=2", "--planner",
                          "sampled: ompl:RRTConnect range=2 --motion=sampled", "--json", runs,
                          "--time-limit", "5", "--table", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "| certified | 2 of 2 |")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "sampled: invalid (")) << outcome.out;
    for (const json& run : json::parse(io::read_file(runs))["runs"])
        EXPECT_EQ(run["status"], run["planner"] == "sampled" ? "invalid" : "solved");
}

TEST(AsvOmpl, IsAPlannerOfAsvBenchInBothDirections) {
    const Outcome outcome =
        bench({testcase_file("3ASV.txt")}, {"--direction", "both", "--planner", "auto", "--planner",
                                            "ompl:KPIECE1", "--time-limit", "10", "--table", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(count(outcome.out, "| ompl:KPIECE1 | 2 of 2 |"), 2U) << outcome.out;
}

TEST(AsvOmpl, WhatItDoesNotTakeAsvBenchDoesNotEither) {
    for (const std::string planner : {"ompl:RRTTT", "ompl:RRT rnage=1", "a: ompl:RRT --speed=2"}) {
        const Outcome outcome = bench({testcase_file("3ASV.txt")}, {"--planner", planner});
        EXPECT_EQ(outcome.exit_code, 2) << planner;
        EXPECT_TRUE(contains(outcome.err, "asv-ompl does not take it")) << outcome.err;
    }
    const Outcome outcome = bench({testcase_file("3ASV.txt")}, {"--planner", "ompl:RRTTT"});
    EXPECT_TRUE(contains(outcome.err, "no planner 'RRTTT'")) << outcome.err;
}

}  // namespace
}  // namespace asv::test
