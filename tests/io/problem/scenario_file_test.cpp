#include "io/problem/scenario_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

using core::BodyKind;

const std::string point =
    R"({"version": 1, "body": {"kind": "point"}, "start": [0, 0], "goal": [1, 1]})";
const std::string arm = R"({"version": 1,
 "body": {"kind": "arm", "base": [1, 0], "links": [2, 1], "angles": "relative", "joints": "wrap"},
 "bounds": null, "start": [0, 1.5], "goal": [1, -7]})";

core::Problem read(const std::string& text) {
    return parse_scenario(text, "s.json", ".").problem;
}

/// The text with one part of it replaced.
std::string with(std::string text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

std::string message(const std::string& text) {
    return test::error_message<ParseError>([&] { read(text); });
}

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
                  "s.json:1:84: warning: any path has 6e+06 steps of 0.001 or more; a larger "
                  "\"step\" would suit this field: the goal is 6000 away at goal"}));
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

struct Mistake {
    std::string text;
    std::string message;
};

/// Texts that are no scenario, or lack a member or have one too many.
std::vector<Mistake> mistakes_of_the_document() {
    return {
        {"{", "s.json:1:2: expected JSON, found the end of the file"},
        {"[]", "s.json:1:1: expected an object at the document, found []"},
        {with(point, "1,", "2,"), "s.json:1:13: expected the integer 1 at version, found 2"},
        {with(point, "\"version\": 1, ", ""),
         "s.json:1:1: expected a member at version, found nothing"},
        {with(point, "\"start\": [0, 0], ", ""),
         "s.json:1:1: expected a member at start, found nothing"},
        {std::string("{}\0}", 4), "s.json:1:3: expected JSON, found \"\\u0000\""},
        {with(point, "\"start\"", "\"stat\": 5, \"start\""),
         "s.json:1:51: expected no other members than version, body, start, goal, bounds, "
         "obstacles, map, step, tolerance at stat, found 5"},
    };
}

/// Bodies and ends that are none.
std::vector<Mistake> mistakes_of_a_point() {
    return {
        {with(point, "{\"kind\": \"point\"}", "7"),
         "s.json:1:24: expected an object at body, found 7"},
        {with(point, "\"point\"", "\"disc\""),
         "s.json:1:33: expected \"chain\", \"arm\" or \"point\" at body.kind, found \"disc\""},
        {with(point, "\"point\"", "\"point\", \"links\": []"),
         "s.json:1:51: expected no other members than kind at body.links, found []"},
        {with(point, "[1, 1]", "[1, 1, 1]"),
         "s.json:1:68: expected a point [x, y] at goal, found [1,1,1]"},
        {with(point, "[1, 1]", "[1, \"1\"]"),
         "s.json:1:72: expected a number at goal[1], found \"1\""},
    };
}

/// Steps, tolerances, bounds, obstacles and maps that are none.
std::vector<Mistake> mistakes_of_the_surroundings() {
    return {
        {with(point, "\"start\"", "\"step\": 0, \"start\""),
         "s.json:1:51: expected a number greater than 0 at step, found 0"},
        {with(point, "\"start\"", "\"tolerance\": -1, \"start\""),
         "s.json:1:56: expected a number of at least 0 at tolerance, found -1"},
        {with(point, "\"start\"", "\"bounds\": [[0, 0], [0, 1]], \"start\""),
         "s.json:1:53: expected a rectangle with an area, or null at bounds, found [[0,0],[0,1]]"},
        {with(point, "\"start\"", "\"obstacles\": [[[0, 0], [-1, 1]]], \"start\""),
         "s.json:1:57: expected a rectangle [[x, y], [x, y]], its lower left corner first at "
         "obstacles[0], found [[0,0],[-1,1]]"},
        {with(point, "\"start\"", "\"obstacles\": 3, \"start\""),
         "s.json:1:56: expected an array of rectangles at obstacles, found 3"},
        {with(point, "\"start\"", "\"map\": {\"file\": 3}, \"start\""),
         "s.json:1:59: expected a string at map.file, found 3"},
        {with(point, "\"start\"", "\"map\": {\"file\": \"x\", \"threshold\": 256}, \"start\""),
         "s.json:1:77: expected a number from 0 to 255 at map.threshold, found 256"},
    };
}

/// Links, joints and angles that are none, or do not fit together.
std::vector<Mistake> mistakes_of_an_arm() {
    return {
        {with(arm, "[2, 1]", "[]"),
         "s.json:2:51: expected at least one link length at body.links, found []"},
        {with(arm, "[2, 1]", "[2, 0]"),
         "s.json:2:55: expected a number greater than 0 at body.links[1], found 0"},
        {with(arm, "\"relative\"", "\"degrees\""),
         "s.json:2:69: expected \"relative\" or \"absolute\" at body.angles, found \"degrees\""},
        {with(arm, "\"wrap\"", "[3, 1]"),
         "s.json:2:91: expected \"wrap\" or angles [low, high] in radians at body.joints, found "
         "[3,1]"},
        {with(arm, "\"wrap\"", "[\"wrap\"]"),
         "s.json:2:91: expected \"wrap\", [low, high], or one of these for each of 2 links at "
         "body.joints, found [\"wrap\"]"},
        {with(arm, "[1, -7]", "[1]"),
         "s.json:3:45: expected an array of 2 joint angles in radians at goal, found [1]"},
        {with(arm, "\"wrap\"", "[0, 2]"),
         "s.json:3:49: expected a number from 0 to 2 at goal[1], found -7"},
        {with(arm, "\"wrap\"", "[0, 2.00000001]"),
         "s.json:3:49: expected a number from 0 to 2.00000001 at goal[1], found -7"},
        {with(arm, "\"bounds\"", "\"step\": 1.5, \"bounds\""),
         "s.json:3:10: expected at most the length of the shortest link at step, found 1.5"},
    };
}

TEST(Scenario, NamesThePlaceOfEveryMistake) {
    for (const auto& mistakes : {mistakes_of_the_document(), mistakes_of_a_point(),
                                 mistakes_of_the_surroundings(), mistakes_of_an_arm()})
        for (const Mistake& mistake : mistakes)
            EXPECT_EQ(message(mistake.text), mistake.message) << mistake.text;
    const std::string chain =
        R"({"version": 1, "body": {"kind": "chain"}, "start": [[0, 0]], "goal": [[0, 0], [1, 1]]})";
    EXPECT_EQ(message(chain),
              "s.json:1:70: expected an array of 1 points at goal, found [[0,0],[1,1]]");
}

}  // namespace
}  // namespace asv::io
