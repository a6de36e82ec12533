#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/io/problem/scenario_samples.hpp"

/// What is said of a scenario that cannot be understood.

namespace asv::io {
namespace {

using namespace scenario_samples;

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
         "s.json:1:51: expected no other members than version, body, start, goal, unit, bounds, "
         "obstacles, map, step, tolerance, limits at stat, found 5"},
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
        {with(point, "\"start\"", "\"limits\": {\"speed\": 0}, \"start\""),
         "s.json:1:63: expected a number from 1e-12 to 1e+12 at limits.speed, found 0"},
        {with(point, "\"start\"", "\"limits\": {\"acceleration\": [1, 2]}, \"start\""),
         "s.json:1:70: expected a number, or an array of one for each of 1 vehicles at "
         "limits.acceleration, found [1,2]"},
        {with(point, "\"start\"", "\"limits\": {\"turn\": 1}, \"start\""),
         "s.json:1:62: expected no other members than speed, acceleration at limits.turn, found 1"},
        {with(point, "\"start\"", "\"tolerance\": -1, \"start\""),
         "s.json:1:56: expected a number of at least 0 at tolerance, found -1"},
        {with(point, "\"start\"", "\"bounds\": [[0, 0], [0, 1]], \"start\""),
         "s.json:1:53: expected a rectangle with an area, or null at bounds, found [[0,0],[0,1]]"},
        {with(point, "\"start\"", "\"obstacles\": [[[0, 0], [-1, 1]]], \"start\""),
         "s.json:1:57: expected a rectangle [[x, y], [x, y]], its lower left corner first at "
         "obstacles[0], found [[0,0],[-1,1]]"},
        {with(point, "\"start\"", "\"bounds\": [[0, 0], [1, 0]], \"start\""),
         "s.json:1:53: expected a rectangle with an area, or null at bounds, found [[0,0],[1,0]]"},
        {with(point, "\"start\"", "\"obstacles\": [[[0, 0]]], \"start\""),
         "s.json:1:57: expected a rectangle [[x, y], [x, y]], its lower left corner first at "
         "obstacles[0], found [[0,0]]"},
        {with(point, "\"start\"", "\"map\": {\"file\": \"x\", \"origin\": 3}, \"start\""),
         "s.json:1:74: expected a point [x, y] at map.origin, found 3"},
        {with(point, "\"start\"", "\"map\": {\"file\": \"x\", \"origin\": [3]}, \"start\""),
         "s.json:1:74: expected a point [x, y] at map.origin, found [3]"},
        {with(point, "\"start\"", "\"map\": {\"file\": \"x\", \"origin\": [0, 0, 1]}, \"start\""),
         "s.json:1:81: expected a number from 0 to 0 at map.origin[2], found 1"},
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
        {with(arm, "\"wrap\"", "[]"),
         "s.json:2:91: expected \"wrap\", [low, high], or one of these for each of 2 links at "
         "body.joints, found []"},
        {with(arm, "\"wrap\"", "\"stop\""),
         "s.json:2:91: expected \"wrap\" or angles [low, high] in radians at body.joints, found "
         "\"stop\""},
        {with(arm, "\"wrap\"", "[1]"),
         "s.json:2:91: expected \"wrap\" or angles [low, high] in radians at body.joints, found "
         "[1]"},
        {with(arm, "[1, -7]", "[1]"),
         "s.json:3:45: expected an array of 2 joint angles in radians at goal, found [1]"},
        {with(arm, "[1, -7]", "[1, -1e20]"),
         "s.json:3:49: expected a number from -1e+06 to 1e+06 at goal[1], found -1e+20"},
        {with(arm, "\"wrap\"", "[0, 1e20]"),
         "s.json:2:95: expected a number from -1e+06 to 1e+06 at body.joints[1], found 1e+20"},
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
    EXPECT_EQ(message(with(chain, "[[0, 0]]", "[]")),
              "s.json:1:52: expected an array of points [x, y], one for each ASV at start, found "
              "[]");
}

/// However many a file promises, what is refused costs little.
TEST(Scenario, RefusesMoreThanItReads) {
    std::string points = "[[0, 0]", links = "[1";
    for (int i = 0; i < 100'000; ++i) {
        points += ",[0,0]";
        links += ",1";
    }
    const std::string chain =
        R"({"version": 1, "body": {"kind": "chain"}, "start": POINTS, "goal": []})";
    EXPECT_TRUE(message(with(chain, "POINTS", points + "]"))
                    .starts_with("s.json:1:52: expected at most 100000 points at start, found "));
    EXPECT_TRUE(
        message(with(arm, "[2, 1]", links + "]"))
            .starts_with("s.json:2:51: expected at most 100000 links at body.links, found "));
}

}  // namespace
}  // namespace asv::io
