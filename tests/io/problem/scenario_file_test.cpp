#include "io/problem/scenario_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/text/parse_error.hpp"
#include "tests/io/problem/scenario_samples.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

using core::BodyKind;
using namespace scenario_samples;

TEST(Scenario, IsToldByItsFirstCharacter) {
    EXPECT_TRUE(is_scenario("{"));
    EXPECT_TRUE(is_scenario("\xEF\xBB\xBF \r\n\t{"));
    EXPECT_FALSE(is_scenario("3\n{"));
    EXPECT_FALSE(is_scenario(""));
}

TEST(Scenario, APointHasTheClassicDefaults) {
    const core::Problem problem = read(point);
    EXPECT_EQ(problem.body_kind(), BodyKind::point);
    EXPECT_EQ(problem.start, (std::vector<geometry::Point>{{0, 0}}));
    EXPECT_EQ(problem.goal, (std::vector<geometry::Point>{{1, 1}}));
    EXPECT_EQ(problem.requirements.max_step, 0.001);
    EXPECT_EQ(problem.requirements.tolerance, 1e-5);
    EXPECT_EQ(problem.requirements.bounds, (geometry::Box{{0, 0}, {1, 1}}));
}

TEST(Scenario, AChainMayHaveOtherBroomsThanTheClassicOne) {
    const core::Problem problem = read(R"({"version": 1,
      "body": {"kind": "chain", "broom_length": 2, "minimum_area_factor": 0.1},
      "start": [[0, 0], [2, 0], [2, 2]], "goal": [[5, 0], [7, 0], [7, 2]],
      "bounds": [[-1, -2], [9, 8]], "obstacles": [[[3, 3], [4, 5]]],
      "step": 0.05, "tolerance": 1e-4})");
    EXPECT_EQ(problem.body_kind(), BodyKind::chain);
    EXPECT_EQ(problem.asv_count(), 3U);
    EXPECT_EQ(problem.requirements.broom_length, 2);
    EXPECT_EQ(problem.requirements.area_radius_per_broom, 0.1);
    EXPECT_EQ(problem.requirements.bounds, (geometry::Box{{-1, -2}, {9, 8}}));
    EXPECT_EQ(problem.obstacles, (std::vector<geometry::Box>{{{3, 3}, {4, 5}}}));
    EXPECT_EQ(problem.requirements.max_step, 0.05);
    EXPECT_EQ(problem.requirements.tolerance, 1e-4);
}

TEST(Scenario, MotionLimitsAreForAllVehiclesOrForEach) {
    EXPECT_EQ(read(point).motion_limits, core::MotionLimits{});
    const std::string limits = R"("limits": {"speed": 1.5, "acceleration": [1, 2, 3]}, "start")";
    const core::MotionLimits read_back = read(with(arm, "\"start\"", limits)).motion_limits;
    EXPECT_EQ(read_back, (core::MotionLimits{{1.5}, {1, 2, 3}})) << "base, joint and tip";
    EXPECT_EQ(read(with(arm, "\"start\"", R"("limits": {}, "start")")).motion_limits,
              core::MotionLimits{});
}

TEST(Scenario, AnArmStandsWhereItsAnglesPutIt) {
    const core::Problem problem = read(arm);
    ASSERT_NE(problem.arm(), nullptr);
    EXPECT_FALSE(problem.requirements.bounded());
    EXPECT_TRUE(problem.arm()->joints[1].wraps);
    ASSERT_EQ(problem.start.size(), 3U);
    EXPECT_EQ(problem.start[0], (geometry::Point{1, 0}));
    EXPECT_NEAR(problem.start[2].x, 3 + std::cos(1.5), 1e-15);
    EXPECT_NEAR(problem.start[2].y, std::sin(1.5), 1e-15);
    const core::Problem absolute = read(with(arm, "relative", "absolute"));
    EXPECT_NEAR(absolute.goal[2].x, 1 + 2 * std::cos(1.0) + std::cos(-7.0), 1e-15);
}

TEST(Scenario, JointsHaveOneRangeOrOneEach) {
    for (const char* joints : {"[-8, 8]", "[[-8, 8], [-8, 8]]"}) {
        const core::Problem problem = read(with(arm, "\"wrap\"", joints));
        EXPECT_EQ(problem.arm()->joints,
                  (std::vector<core::JointRange>{{false, -8, 8}, {false, -8, 8}}));
    }
    const core::Problem mixed = read(with(arm, "\"wrap\"", "[[-8, 8], \"wrap\"]"));
    EXPECT_FALSE(mixed.arm()->joints[0].wraps);
    EXPECT_TRUE(mixed.arm()->joints[1].wraps);
}

TEST(Scenario, AMapGivesObstaclesAndBounds) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "m.txt") << "height 2\nwidth 3\n100\n001\n";
    const std::string text = with(
        point, "\"start\"", R"("map": {"file": "m.txt", "cell": 10, "origin": [-5, 0]}, "start")");
    const core::Problem problem = parse_scenario(text, "s.json", folder.path()).problem;
    EXPECT_EQ(problem.obstacles,
              (std::vector<geometry::Box>{{{15, 0}, {25, 10}}, {{-5, 10}, {5, 20}}}));
    EXPECT_EQ(problem.requirements.bounds, (geometry::Box{{-5, 0}, {25, 20}}));
    // A scenario may set bounds of its own, and cells may be too thin to be kept.
    const ProblemFile thin = parse_scenario(
        with(with(text, "\"cell\": 10", "\"cell\": 1e-6"), "\"map\"", "\"bounds\": null, \"map\""),
        "s.json", folder.path());
    EXPECT_FALSE(thin.problem.requirements.bounded());
    ASSERT_EQ(thin.warnings.size(), 1U);
    EXPECT_NE(to_text(thin.warnings[0]).find("warning: a rectangle of cells is "),
              std::string::npos);
    // A file problem is told by its place in the scenario.
    EXPECT_NE(message(text).find("map.file"), std::string::npos);
}

std::string with_map(const std::string& file) {
    return with(point, "\"start\"", "\"map\": {\"file\": \"" + file + "\"}, \"start\"");
}

// What a scenario of somebody else may name: see docs/scenario.md.
TEST(Scenario, AMapIsARegularFileBelowTheScenario) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "s/maps");
    for (const char* name : {"outside.map", "s/here.map", "s/maps/below.map"})
        std::ofstream(folder / name) << "01\n";
    std::filesystem::create_symlink("../outside.map", folder / "s/link.map");
    ASSERT_EQ(::mkfifo((folder / "s/pipe").c_str(), 0600), 0);
    const auto read_with = [&](const std::string& file, bool anywhere) {
        return parse_scenario(with_map(file), "s.json", folder / "s", {.maps_anywhere = anywhere});
    };
    const auto refusal = [&](const std::string& file, bool anywhere = false) {
        return test::error_message<ParseError>([&] { read_with(file, anywhere); });
    };
    for (const char* name : {"here.map", "maps/below.map", "maps/../here.map", "./here.map"}) {
        const ProblemFile read = read_with(name, false);
        EXPECT_EQ(read.problem.obstacles.size(), 1U);
        EXPECT_TRUE(std::filesystem::equivalent(read.maps.at(0), folder / "s" / name) ||
                    std::string(name).starts_with("maps/.."));
    }
    const std::string absolute = (folder / "s/here.map").string();
    EXPECT_NE(refusal(absolute).find("a path relative to the scenario"), std::string::npos);
    for (const char* name : {"../outside.map", "link.map", "maps/../../outside.map"}) {
        EXPECT_NE(refusal(name).find("a file below the folder of the scenario"), std::string::npos);
        EXPECT_EQ(read_with(name, true).problem.obstacles.size(), 1U);
    }
    EXPECT_EQ(read_with(absolute, true).problem.obstacles.size(), 1U);
    EXPECT_NE(refusal("pipe").find("pipe: not a regular file"), std::string::npos);
    EXPECT_NE(refusal("/dev/zero", true).find("/dev/zero: not a regular file"), std::string::npos);
    EXPECT_NE(refusal("here.map\\u0000.png").find("the name of a file"), std::string::npos);
    EXPECT_NE(refusal("").find("the name of a file"), std::string::npos);
    EXPECT_EQ(refusal("\\u001b[31m").find('\x1b'), std::string::npos);
}

TEST(Scenario, SaysItsUnitForPeople) {
    const auto unit = [](const std::string& name) {
        return parse_scenario(with(point, "\"start\"", "\"unit\": \"" + name + "\", \"start\""),
                              "s.json", ".")
            .unit;
    };
    EXPECT_EQ(parse_scenario(point, "s.json", ".").unit, "");
    EXPECT_EQ(unit("µm"), "µm");
    EXPECT_EQ(unit("nautical  miles!"), "nautical  miles!");
    for (const char* wrong : {"", "nautical   miles!", "a\\nb"})
        EXPECT_THROW(unit(wrong), ParseError) << wrong;
}

TEST(Scenario, StepAndToleranceFollowFromTheBrooms) {
    const std::string chain =
        R"({"version": 1, "body": {"kind": "chain"}, "start": [[0, 0]], "goal": [[0, 0]]})";
    const core::Requirements usual = read(chain).requirements;
    EXPECT_EQ(usual.max_step, core::Requirements{}.max_step);
    EXPECT_EQ(usual.tolerance, core::Requirements{}.tolerance);
    const std::string in_metres = with(chain, "\"chain\"", "\"chain\", \"broom_length\": 20");
    EXPECT_EQ(read(in_metres).requirements.max_step, 0.4);
    EXPECT_EQ(read(in_metres).requirements.tolerance, 0.004);
    const core::Requirements given =
        read(with(in_metres, "\"start\"", "\"step\": 3, \"tolerance\": 0, \"start\"")).requirements;
    EXPECT_EQ(given.max_step, 3);
    EXPECT_EQ(given.tolerance, 0);
    // Other bodies have no brooms.
    EXPECT_EQ(read(arm).requirements.max_step, core::Requirements{}.max_step);
}

TEST(Scenario, WarnsAboutWallsThatVanishAndStepsThatDoNotSuit) {
    const auto warnings = [](const std::string& text) {
        std::vector<std::string> texts;
        for (const Warning& warning : parse_scenario(text, "s.json", ".").warnings)
            texts.push_back(to_text(warning));
        return texts;
    };
    EXPECT_TRUE(warnings(point).empty());
    EXPECT_EQ(
        warnings(with(point, "\"start\"",
                      "\"obstacles\": [[[5, 5], [6, 6]],\n [[0.5, 0], [0.5, 1]]], \"start\"")),
        (std::vector<std::string>{
            "s.json:2:2: warning: the rectangle is 0 wide, less than twice the tolerance of "
            "1e-05, and vanishes at obstacles[1]"}));
    EXPECT_EQ(warnings(with(with(point, "[1, 1]", "[6000, 0]"), "\"start\"",
                            "\"bounds\": null, \"start\"")),
              (std::vector<std::string>{
                  "s.json:1:84: warning: any path has 6e+06 steps of 0.001 or more (a "
                  "\"step\" of 0.1 would fit): the goal is 6000 away at goal"}));
}

TEST(Scenario, ListsNoMoreThanAHundredWarnings) {
    std::string walls = "[[1, 0], [1, 1]]";
    for (int i = 1; i < 250; ++i) walls += ", [[1, 0], [1, 1]]";
    const ProblemFile file = parse_scenario(
        with(point, "\"start\"", "\"obstacles\": [" + walls + "], \"start\""), "s.json", ".");
    ASSERT_EQ(file.warnings.size(), 100U);
    EXPECT_NE(to_text(file.warnings.back()).find("(150 further warnings are not listed)"),
              std::string::npos);
}

TEST(Scenario, AByteOrderMarkMovesNoColumn) {
    EXPECT_EQ(message("\xEF\xBB\xBF" + with(point, "[0, 0]", "[0]")),
              message(with(point, "[0, 0]", "[0]")));
}

TEST(Scenario, KnowsTheLinesOfItsEnds) {
    const ProblemFile file = parse_scenario(with(arm, "\"goal\"", "\n\n\"goal\""), "s.json", ".");
    EXPECT_EQ(file.start_line, 3U);
    EXPECT_EQ(file.goal_line, 5U);
}

}  // namespace
}  // namespace asv::io
