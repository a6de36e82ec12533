#include <limits>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"

/// What a report says in words.

namespace asv::core {
namespace {

TEST(Describe, SaysWhoIsToBlameAndByHowMuch) {
    Offender offender;
    offender.asv = 1;
    offender.broom = 2;
    offender.obstacle = 4;
    offender.room = -0.0012;
    EXPECT_EQ(describe(Check::ends, offender), "ASV 2 misses its place by 0.0012");
    EXPECT_EQ(describe(Check::steps, offender), "ASV 2 moves too far by 0.0012");
    EXPECT_EQ(describe(Check::cost, offender), "the written cost is wrong by 0.0012");
    EXPECT_EQ(describe(Check::broom_lengths, offender),
              "broom 3 is too long or too short by 0.0012");
    EXPECT_EQ(describe(Check::convexity, offender),
              "the turn at ASV 2 is against the others by 0.0012 rad");
    EXPECT_EQ(describe(Check::area, offender), "the area is too small by 0.0012");
    EXPECT_EQ(describe(Check::bounds, offender), "ASV 2 is out of bounds by 0.0012");
    EXPECT_EQ(describe(Check::collisions, offender), "broom 3 meets obstacle 5 by 0.0012");
}

TEST(Describe, SpeaksOfTheBaseAndTheLinksOfAnArm) {
    Offender offender;
    offender.body = BodyKind::arm;
    offender.asv = 1;
    offender.broom = 2;
    offender.room = -0.0012;
    EXPECT_EQ(describe(Check::bounds, offender), "point 2 is out of bounds by 0.0012");
    EXPECT_EQ(describe(Check::link_lengths, offender), "link 3 is too long or too short by 0.0012");
    EXPECT_EQ(describe(Check::base, offender), "the base has moved by 0.0012");
    EXPECT_EQ(describe(Check::joint_limits, offender), "joint 2 is past its limit by 0.0012 rad");
}

TEST(Describe, SpeaksOfTrajectories) {
    Offender offender;
    offender.room = -0.0012;
    EXPECT_EQ(describe(Check::times, offender),
              "the time does not increase: it changes by 0.0012 s");
    offender.asv = 1;
    EXPECT_EQ(describe(Check::same_path, offender), "ASV 2 leaves the path by 0.0012");
    EXPECT_EQ(describe(Check::speed, offender), "ASV 2 is too fast by 0.0012");
    EXPECT_EQ(describe(Check::acceleration, offender),
              "ASV 2 changes its velocity too fast by 0.0012");
    offender.body = BodyKind::point;
    EXPECT_EQ(describe(Check::speed, offender), "the point is too fast by 0.0012");
}

TEST(Describe, TellsALengthAndTheOneThatIsWanted) {
    Offender offender;
    offender.broom = 1;
    offender.wanted_length = 0.05;
    offender.length = 0.0447214;
    offender.room = 1e-5 - (0.05 - 0.0447214);
    EXPECT_EQ(describe(Check::broom_lengths, offender),
              "broom 2 is 0.0447 long, 0.05 within 1e-5 is wanted");
    offender.length = 0.0500123;
    offender.room = 1e-5 - 0.0000123;
    EXPECT_EQ(describe(Check::broom_lengths, offender),
              "broom 2 is 0.050012 long, 0.05 within 1e-5 is wanted");
}

TEST(Describe, TellsALargeToleranceToo) {
    Offender offender;
    offender.broom = 0;
    offender.wanted_length = 1;
    offender.length = 1.5;
    offender.room = 0.25 - 0.5;
    EXPECT_EQ(describe(Check::broom_lengths, offender),
              "broom 1 is 1.5 long, 1 within 0.25 is wanted");
}

TEST(Describe, ALengthWithoutRoomHasAllDigits) {
    Offender offender;
    offender.broom = 0;
    offender.wanted_length = offender.length = 0.05;
    EXPECT_EQ(describe(Check::broom_lengths, offender),
              "broom 1 is 0.050000000000000003 long, 0.050000000000000003 within 0 is wanted");
}

TEST(Describe, AnInfiniteLengthHasNoDigits) {
    const double infinite = std::numeric_limits<double>::infinity();
    Offender offender;
    offender.broom = 0;
    offender.wanted_length = 0.05;
    offender.length = infinite;
    offender.room = -infinite;
    EXPECT_EQ(describe(Check::broom_lengths, offender), "broom 1 is too long or too short by inf");
}

TEST(Describe, KnowsTheThreeOtherWaysNotToBeConvex) {
    Offender offender;
    offender.asv = 2;
    EXPECT_EQ(describe(Check::convexity, offender), "the turn at ASV 3 is exactly pi");
    offender.time = 0.5;
    EXPECT_EQ(describe(Check::convexity, offender), "the side after ASV 3 shrinks to a point");
    offender.asv.reset();
    offender.room = -3.14;
    EXPECT_EQ(describe(Check::convexity, offender),
              "the turns add up to more than 3 pi by 3.14 rad");
}

TEST(Describe, ShowsTheRoomOfWhatHolds) {
    CheckResult result;
    result.check = Check::collisions;
    EXPECT_EQ(describe(result), "nothing to check");
    result.worst.emplace();
    result.worst->broom = 0;
    result.worst->obstacle = 6;
    result.worst->room = 0.25;
    EXPECT_EQ(describe(result), "room 0.25 at broom 1, obstacle 7");
    // A point has no parts to name.
    result.worst->body = BodyKind::point;
    EXPECT_EQ(describe(result), "room 0.25 at obstacle 7");
}

TEST(Describe, ShowsTheRoomOfASVsAndJoints) {
    CheckResult result;
    result.worst.emplace();
    result.worst->asv = 1;
    result.worst->room = 0.25;
    result.check = Check::bounds;
    EXPECT_EQ(describe(result), "room 0.25 at ASV 2");
    result.worst->body = BodyKind::arm;
    EXPECT_EQ(describe(result), "room 0.25 at point 2");
    result.check = Check::joint_limits;
    EXPECT_EQ(describe(result), "room 0.25 at joint 2");
    result.worst->body = BodyKind::point;
    result.check = Check::bounds;
    EXPECT_EQ(describe(result), "room 0.25");
}

TEST(Describe, NamesEveryCheck) {
    const std::vector<std::string_view> names = {
        "ends",   "steps",      "cost",         "broom lengths", "convexity",   "area",
        "bounds", "collisions", "link lengths", "base",          "joint limits"};
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(name(static_cast<Check>(i)), names[i]);
}

}  // namespace
}  // namespace asv::core
