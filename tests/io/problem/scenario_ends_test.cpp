#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"
#include "tests/io/problem/scenario_samples.hpp"

/// Starts and goals that people write by hand.

namespace asv::io {
namespace {

using namespace scenario_samples;
constexpr double pi = std::numbers::pi;

const std::string shapes = R"({"version": 1, "body": {"kind": "chain", "asv_count": 7},
 "start": {"shape": "line", "at": [0.1, 0.5], "heading": 0},
 "goal": {"shape": "hook", "at": [0.6, 0.5], "heading": 90}})";
const std::string turns = R"({"version": 1, "body": {"kind": "chain"},
 "start": {"at": [0.1, 0.5], "heading": 90, "turns": [-90, -45]},
 "goal": {"shape": "arc", "at": [0.6, 0.5], "heading": -30, "orientation": "clockwise"}})";
const std::string points =
    R"({"version": 1, "body": {"kind": "chain"}, "start": {"shape": "arc", "at": [0, 0], "heading": 0},
 "goal": [[0.5, 0.5], [0.55, 0.5], [0.55, 0.55]]})";

void expect_near(const geometry::Point& point, double x, double y) {
    EXPECT_NEAR(point.x, x, 1e-15);
    EXPECT_NEAR(point.y, y, 1e-15);
}

TEST(ScenarioEnds, TurnsLeadFromBroomToBroom) {
    const core::Problem problem = read(turns);
    ASSERT_EQ(problem.start.size(), 4U);
    expect_near(problem.start[0], 0.1, 0.5);
    expect_near(problem.start[1], 0.1, 0.55);
    expect_near(problem.start[2], 0.15, 0.55);
    const double slope = 0.05 * std::sqrt(0.5);
    expect_near(problem.start[3], 0.15 + slope, 0.55 - slope);
    EXPECT_EQ(problem.goal.size(), 4U);
    EXPECT_TRUE(core::invalid_ends(problem).empty());
}

TEST(ScenarioEnds, ShapesMeetTheRequirementsAndAreAsLargeAsTheBody) {
    EXPECT_TRUE(core::invalid_ends(read(shapes)).empty());
    EXPECT_EQ(read(shapes).goal.size(), 7U);
    // The end that lists its places tells how many ASVs there are, whichever it is.
    EXPECT_EQ(read(points).start.size(), 3U);
    const core::Problem other = read(R"({"version": 1, "body": {"kind": "chain"},
 "start": {"at": [0.2, 0.2], "heading": 0, "turns": [90, 90]},
 "goal": {"shape": "line", "at": [0.5, 0.5], "heading": 0}})");
    EXPECT_EQ(other.goal.size(), 4U);
}

TEST(ScenarioEnds, AreAsLongAsTheBroomsOfTheBody) {
    const core::Problem problem = read(with(
        with(turns, "\"chain\"", "\"chain\", \"broom_length\": 2, \"minimum_area_factor\": 0.28"),
        "\"start\"", "\"bounds\": null, \"start\""));
    expect_near(problem.start[1], 0.1, 2.5);
    EXPECT_NEAR(
        std::hypot(problem.goal[1].x - problem.goal[0].x, problem.goal[1].y - problem.goal[0].y), 2,
        1e-15);
}

TEST(ScenarioEnds, OfAnArmAreToldInDegreesAsWell) {
    const std::string by_hand = with(arm, "[0, 1.5]", R"({"heading": 90, "turns": [-45]})");
    const core::Problem relative = read(by_hand);
    EXPECT_EQ(relative.arm()->start, (std::vector<double>{pi / 2, -pi / 4}));
    const core::Problem absolute = read(with(by_hand, "relative", "absolute"));
    EXPECT_EQ(absolute.arm()->start, (std::vector<double>{pi / 2, pi / 4}));
    EXPECT_EQ(absolute.start, relative.start);
}

std::vector<Mistake> mistakes_of_shapes() {
    return {
        {with(shapes, "\"hook\"", "\"ring\""),
         "s.json:3:20: expected \"line\", \"arc\" or \"hook\" at goal.shape, found \"ring\""},
        {with(shapes, ", \"asv_count\": 7", ""),
         "s.json:1:24: expected the number of ASVs, which shapes do not tell, at "
         "body.asv_count, found nothing"},
        {with(shapes, "\"asv_count\": 7", "\"asv_count\": 2"),
         "s.json:2:11: expected a shape of 2 ASVs that meets the requirements (2 ASVs enclose no "
         "area) at start, found {\"at\":[0.1,0.5],\"heading\":0,\"shape\":\"lin..."},
        {with(shapes, "\"heading\": 0", "\"heading\": 0, \"bend\": 90"),
         "s.json:2:69: expected no other members than shape, at, heading, orientation at "
         "start.bend, found 90"},
        {with(shapes, "\"heading\": 90", "\"heading\": 90, \"leg\": 6"),
         "s.json:3:68: expected an integer from 1 to 5 at goal.leg, found 6"},
        {with(shapes, "\"heading\": 90", "\"heading\": 90, \"bend\": 360"),
         "s.json:3:69: expected a number between 0 and 360, neither included at goal.bend, found "
         "360"},
        {with(shapes, "\"heading\": 90", "\"heading\": 90, \"orientation\": \"left\""),
         "s.json:3:76: expected \"counter-clockwise\" or \"clockwise\" at goal.orientation, found "
         "\"left\""},
        {with(shapes, "\"heading\": 90", "\"heading\": 1e5"),
         "s.json:3:57: expected a number from -3600 to 3600 at goal.heading, found 100000.0"},
        {with(shapes, "\"at\": [0.6, 0.5], ", ""),
         "s.json:3:10: expected a member at goal.at, found nothing"},
    };
}

std::vector<Mistake> mistakes_of_turns() {
    return {
        {with(turns, "[-90, -45]", "[-90, -181]"),
         "s.json:2:60: expected a number from -180 to 180 at start.turns[1], found -181"},
        {with(turns, "\"chain\"", "\"chain\", \"asv_count\": 5"),
         "s.json:2:54: expected an array of 3 turns in degrees at start.turns, found [-90,-45]"},
        {with(turns, "\"chain\"", "\"chain\", \"asv_count\": 1"),
         "s.json:2:11: expected an array of 1 points at start, found "
         "{\"at\":[0.1,0.5],\"heading\":90,\"turns\":[-9..."},
        {with(turns, "\"heading\": 90, ", ""),
         "s.json:2:11: expected a member at start.heading, found nothing"},
        {with(arm, "[0, 1.5]", R"({"heading": 90, "turns": [-45, 1]})"),
         "s.json:3:52: expected an array of 1 turns in degrees at start.turns, found [-45,1]"},
        {with(arm, "[0, 1.5]", R"({"at": [0, 0], "heading": 90, "turns": [-45]})"),
         "s.json:3:34: expected no other members than heading, turns at start.at, found [0,0]"},
        {with(with(arm, "\"wrap\"", "[-1.5707963267948966, 0.5]"), "[0, 1.5]",
              R"({"heading": 0, "turns": [-90.5]})"),
         "s.json:3:52: expected an angle of joint 2 from -90 to 28.64788975654116 degrees at "
         "start.turns[0], found -90.5"},
    };
}

TEST(ScenarioEnds, NameThePlaceOfEveryMistake) {
    for (const auto& mistakes : {mistakes_of_shapes(), mistakes_of_turns()})
        for (const Mistake& mistake : mistakes)
            EXPECT_EQ(message(mistake.text), mistake.message) << mistake.text;
}

TEST(ScenarioEnds, SayWhichRequirementAShapeWouldViolate) {
    const std::string flat =
        message(with(turns, "\"orientation\"", "\"bend\": 5, \"orientation\""));
    EXPECT_TRUE(
        flat.starts_with("s.json:3:10: expected a shape of 4 ASVs that meets the "
                         "requirements (the area is too small by 0.00"))
        << flat;
}

}  // namespace
}  // namespace asv::io
