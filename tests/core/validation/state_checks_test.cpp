#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"
#include "tests/core/validation/tolerance.hpp"
#include "tests/kit/chains/paths.hpp"
#include "tests/kit/check_results.hpp"

/// The five checks of one state: just inside and just outside of every limit.

namespace asv::core {
namespace {

using std::numbers::pi;
using test::chain_with_turns;
using test::Points;
using Checks = std::vector<Check>;

constexpr double bit = 1e-9;  // far below e and far above rounding

std::vector<CheckResult> check(const Points& chain, const std::vector<Box>& obstacles = {},
                               double tolerance = e) {
    Problem problem;
    problem.start = problem.goal = chain;
    problem.obstacles = obstacles;
    return validate_state(problem, chain, {.tolerance = tolerance}).checks;
}

Checks failures(const Points& chain, const std::vector<Box>& obstacles = {}, double tolerance = e) {
    return test::failed(check(chain, obstacles, tolerance));
}

Offender worst(Check which, const Points& chain, const std::vector<Box>& obstacles = {},
               double tolerance = e) {
    return test::find(check(chain, obstacles, tolerance), which).worst.value();
}

Points mirrored(Points chain) {
    for (Point& point : chain) point.x = 1 - point.x;
    return chain;
}

TEST(ValidateState, AGoodStateMeetsEveryRequirement) {
    EXPECT_EQ(failures(test::corner()), Checks{});
    EXPECT_EQ(failures(mirrored(test::corner())), Checks{});
    const std::vector<CheckResult> checks = check(test::corner());
    ASSERT_EQ(checks.size(), 5U);
    for (const CheckResult& result : checks) {
        EXPECT_EQ(result.states, 1U);
        EXPECT_EQ(result.failures, 0U);
        EXPECT_TRUE(result.offenders.empty());
    }
    EXPECT_EQ(checks[0].check, Check::broom_lengths);
    EXPECT_EQ(checks[4].check, Check::collisions);
    EXPECT_FALSE(checks[4].worst);
}

TEST(ValidateState, BroomsAreAsLongAsTheToleranceAllows) {
    const auto with_length = [](double length) {
        return Points{{0.5, 0.5}, {0.55, 0.5}, {0.55, 0.5 + length}};
    };
    EXPECT_EQ(failures(with_length(0.05 + e - bit)), Checks{});
    EXPECT_EQ(failures(with_length(0.05 - e + bit)), Checks{});
    EXPECT_EQ(failures(with_length(0.05 + e + bit)), Checks{Check::broom_lengths});
    EXPECT_EQ(failures(with_length(0.05 - e - bit)), Checks{Check::broom_lengths});
    EXPECT_EQ(failures(with_length(0.05 + 0.5e-3), {}, 1e-3), Checks{});
    const Offender offender = worst(Check::broom_lengths, with_length(0.06));
    EXPECT_EQ(offender.broom, 1U);
    EXPECT_FALSE(offender.asv);
    EXPECT_NEAR(offender.room, e - 0.01, 1e-15);
    EXPECT_NEAR(worst(Check::broom_lengths, with_length(0.05 - e / 4)).room, 0.75 * e, 1e-15);
}

TEST(ValidateState, ATurnAgainstTheOthersMayBeAsLargeAsTheTolerance) {
    const auto with_turn = [](double turn) {
        return chain_with_turns({0.4, 0.4}, 0.3, {0.8, turn, 0.9});
    };
    for (const double turn : {0.0, -e + bit, e - bit, e + bit}) {
        EXPECT_EQ(failures(with_turn(turn)), Checks{}) << turn;
        EXPECT_EQ(failures(mirrored(with_turn(turn))), Checks{}) << turn;
    }
    EXPECT_EQ(failures(with_turn(-e - bit)), Checks{Check::convexity});
    EXPECT_EQ(failures(mirrored(with_turn(-e - bit))), Checks{Check::convexity});
    EXPECT_EQ(failures(with_turn(-1e-3), {}, 2e-3), Checks{});
    const Offender offender = worst(Check::convexity, with_turn(-0.1));
    EXPECT_EQ(offender.asv, 2U);
    EXPECT_NEAR(offender.room, e - 0.1, 1e-12);
    EXPECT_EQ(worst(Check::convexity, mirrored(with_turn(-0.1))).asv, 2U);
    EXPECT_NEAR(worst(Check::convexity, with_turn(0.1)).room, e + 0.1, 1e-12);
}

TEST(ValidateState, TheTurnsAtTheClosingSideCount) {
    // ASV 4 ends inside the triangle of the others, so that the closing side turns back there.
    const Points inwards = chain_with_turns({0.4, 0.4}, 0, {pi / 2, pi * 5 / 6});
    EXPECT_EQ(failures(inwards), (Checks{Check::convexity, Check::area}));
    EXPECT_EQ(worst(Check::convexity, inwards).asv, 3U);
    const Points reversed(inwards.rbegin(), inwards.rend());
    EXPECT_EQ(worst(Check::convexity, reversed).asv, 0U);
}

TEST(ValidateState, AStraightClosingTurnIsAllowedWithinTheTolerance) {
    // ASV 1 stands in the middle of a long side; raised by d it turns back by d / 0.025.
    const auto raised = [](double d) {
        return Points{{0.5, 0.5 + d}, {0.55, 0.5},  {0.55, 0.55},
                      {0.5, 0.55},    {0.45, 0.55}, {0.45, 0.5}};
    };
    EXPECT_EQ(failures(raised(0)), Checks{});
    EXPECT_EQ(failures(raised(0), {}, 1e-14), Checks{});
    EXPECT_EQ(failures(raised(0.999 * e * 0.025)), Checks{});
    EXPECT_EQ(failures(raised(1.001 * e * 0.025)), Checks{Check::convexity});
    EXPECT_EQ(worst(Check::convexity, raised(1e-6)).asv, 0U);
}

TEST(ValidateState, ATurnOfExactlyPiFails) {
    const Points folded = {{0.5, 0.5}, {0.55, 0.5}, {0.5, 0.5}};
    EXPECT_EQ(failures(folded), (Checks{Check::convexity, Check::area}));
    const Offender offender = worst(Check::convexity, folded);
    EXPECT_EQ(offender.asv, 1U);
    EXPECT_EQ(offender.room, 0);
}

TEST(ValidateState, TurnsMayNotAddUpToTwoWindings) {
    // A pentagram: five turns of 144 degrees, 4 pi together.
    const double turn = 0.8 * pi;
    const Points star = chain_with_turns({0.5, 0.5}, 0, {turn, turn, turn});
    const std::vector<CheckResult> results = check(star);
    const CheckResult& convexity = test::find(results, Check::convexity);
    EXPECT_FALSE(convexity.ok());
    EXPECT_FALSE(convexity.worst.value().asv);
    EXPECT_NEAR(convexity.worst.value().room, -pi, 1e-9);
}

TEST(ValidateState, TheAreaMayMissItsMinimumByTheTolerance) {
    const double least = pi * 0.014 * 0.014 - e;
    const auto with_area = [](double area) {
        return chain_with_turns({0.5, 0.5}, 0.2, {std::asin(area / 0.00125)});
    };
    EXPECT_EQ(failures(with_area(least + bit)), Checks{});
    EXPECT_EQ(failures(with_area(least - bit)), Checks{Check::area});
    EXPECT_EQ(failures(mirrored(with_area(least + bit))), Checks{});
    EXPECT_EQ(failures(mirrored(with_area(least - bit))), Checks{Check::area});
    EXPECT_NEAR(worst(Check::area, with_area(least - 1e-4)).room, -1e-4, 1e-15);
    EXPECT_NEAR(worst(Check::area, test::corner()).room, 0.00125 - least, 1e-15);
}

TEST(ValidateState, BoundsAreClosedBelowAndOpenAbove) {
    const auto at = [](double x, double y) {
        return test::moved(test::corner(), x - 0.5, y - 0.5);
    };
    EXPECT_EQ(failures(at(-e + bit, 0.5)), Checks{});
    EXPECT_EQ(failures(at(0.5, -e + bit)), Checks{});
    EXPECT_EQ(failures(at(-e - bit, 0.5)), Checks{Check::bounds});
    EXPECT_EQ(failures(at(0.5, -e - bit)), Checks{Check::bounds});
    EXPECT_EQ(failures(at(0.95 + e - bit, 0.5)), Checks{});
    EXPECT_EQ(failures(at(0.5, 0.95 + e - bit)), Checks{});
    EXPECT_EQ(failures(at(0.95 + e + bit, 0.5)), Checks{Check::bounds});
    EXPECT_EQ(failures(at(0.5, 0.95 + e + bit)), Checks{Check::bounds});
    const Offender offender = worst(Check::bounds, at(0.5, 1.0));
    EXPECT_EQ(offender.asv, 2U);
    EXPECT_NEAR(offender.room, e - 0.05, 1e-12);
}

TEST(ValidateState, TheBoundsThemselvesBelongToOneSideOnly) {
    const auto only = [](double x) { return failures(Points{{x, 0.5}}); };
    EXPECT_EQ(only(-e), Checks{});
    EXPECT_EQ(only(std::nextafter(-e, -1)), Checks{Check::bounds});
    EXPECT_EQ(only(1 + e), Checks{Check::bounds});
    EXPECT_EQ(only(std::nextafter(1 + e, 0)), Checks{});
}

// With a tolerance of a power of two, shrinking by it is exact.
TEST(ValidateState, TouchingTheShrunkObstacleIsACollision) {
    const double tolerance = std::ldexp(1.0, -17);
    const auto box_below = [](double top) { return std::vector<Box>{{{0.25, 0.25}, {0.75, top}}}; };
    const double touching_top = 0.5 + tolerance;
    const double lower_top = std::nextafter(touching_top, 0.0);
    EXPECT_EQ(failures(test::corner(), box_below(touching_top), tolerance),
              Checks{Check::collisions});
    EXPECT_EQ(failures(test::corner(), box_below(lower_top), tolerance), Checks{});
    const Offender touching =
        worst(Check::collisions, test::corner(), box_below(touching_top), tolerance);
    EXPECT_EQ(touching.broom, 0U);
    EXPECT_EQ(touching.obstacle, 0U);
    EXPECT_EQ(touching.room, 0);
}

TEST(ValidateState, ObstaclesThinnerThanTwiceTheToleranceVanish) {
    const double tolerance = std::ldexp(1.0, -17);
    const auto thick = [&](double thickness) {
        return std::vector<Box>{{{0.525, 0.25}, {0.525 + thickness, 0.75}}};
    };
    EXPECT_EQ(failures(test::corner(), thick(1.5 * tolerance), tolerance), Checks{});
    EXPECT_EQ(failures(test::corner(), thick(0), tolerance), Checks{});
    EXPECT_EQ(failures(test::corner(), thick(2.5 * tolerance), tolerance),
              Checks{Check::collisions});
    EXPECT_FALSE(test::find(check(test::corner(), thick(0), tolerance), Check::collisions).worst);
}

TEST(ValidateState, ABroomInsideAnObstacleCollides) {
    EXPECT_EQ(failures(test::corner(), {{{0.4, 0.4}, {0.6, 0.6}}}), Checks{Check::collisions});
}

TEST(ValidateState, TheClosingSideAndTheInsideMayCoverObstacles) {
    EXPECT_EQ(failures(test::corner(), {{{0.52, 0.51}, {0.54, 0.54}}}), Checks{});
}

TEST(ValidateState, RoomAmongObstaclesIsTheDistanceOrThePenetration) {
    const std::vector<Box> apart = {
        {{0.1, 0.1}, {0.2, 0.2}}, {{0.51, 0.3}, {0.53, 0.49}}, {{0.58, 0.58}, {0.7, 0.7}}};
    const Offender near = worst(Check::collisions, test::corner(), apart);
    EXPECT_EQ(near.broom, 0U);
    EXPECT_EQ(near.obstacle, 1U);
    EXPECT_NEAR(near.room, 0.01 + e, 1e-15);
    const Offender deep = worst(Check::collisions, test::corner(),
                                {{{0.51, 0.3}, {0.53, 0.502}}, {{0.54, 0.52}, {0.7, 0.53}}});
    EXPECT_EQ(deep.broom, 1U);
    EXPECT_EQ(deep.obstacle, 1U);
    EXPECT_NEAR(deep.room, -(0.01 - e), 1e-12);
}

TEST(ValidateState, PenetrationOfASlantedBroomIsMeasuredAcrossIt) {
    const Points chain = chain_with_turns({0.4, 0.4}, pi / 4, {2.0});
    // The corner of the box is 0.001 beyond the broom's middle.
    const double middle = 0.4 + 0.025 * std::numbers::sqrt2 / 2;
    const double beyond = 0.001 * std::numbers::sqrt2 / 2;
    const std::vector<Box> boxes = {
        {{middle - beyond - e, middle - 0.3}, {middle + 0.3, middle + beyond - 0.02}},
        {{middle - beyond - e, middle - 0.3}, {middle + 0.3, middle + beyond + e}}};
    EXPECT_NEAR(worst(Check::collisions, chain, {boxes[1]}).room, -0.001, 1e-12);
}

TEST(ValidateState, OneAsvIsAPoint) {
    EXPECT_EQ(failures(Points{{0.5, 0.5}}, {{{0.4, 0.4}, {0.6, 0.6}}}), Checks{});
    EXPECT_EQ(failures(Points{{0.5, 0.5}}, {}, 0), Checks{});
    EXPECT_EQ(failures(Points{{1.5, 0.5}}), Checks{Check::bounds});
}

TEST(ValidateState, TwoAsvsHaveNoArea) {
    for (const double heading : {0.0, 0.1, 1.3, 2.9, -2.0}) {
        const Checks checks = failures(chain_with_turns({0.5, 0.5}, heading, {}));
        EXPECT_EQ(checks, (Checks{Check::convexity, Check::area})) << heading;
    }
}

TEST(ValidateState, WhatIsNotFiniteFailsEveryCheck) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Points chain = test::corner();
        chain[1].y = bad;
        const std::vector<CheckResult> results = check(chain, {{{0.4, 0.4}, {0.6, 0.6}}});
        EXPECT_EQ(test::failed(results).size(), 5U);
        for (const CheckResult& result : results) {
            EXPECT_EQ(describe(result), "ASV 2 has no finite position");
        }
    }
}

TEST(ValidateState, HugeCoordinatesFailWithoutHarm) {
    const Points chain = {{1e70, 0.5}, {-1e70, 1e70}, {0.5, 0.5}};
    const Checks checks = failures(chain, {{{0.4, 0.4}, {0.6, 0.6}}, {{-1e70, -1e70}, {0, 0}}});
    EXPECT_EQ(checks, (Checks{Check::broom_lengths, Check::bounds, Check::collisions}));
}

TEST(ValidateState, RefusesArgumentsWithoutMeaning) {
    const Problem problem;
    EXPECT_THROW(validate_state(problem, {}), std::invalid_argument);
    const Points chain = test::corner();
    EXPECT_THROW(validate_state(problem, chain, {.tolerance = -1}), std::invalid_argument);
    EXPECT_THROW(
        validate_state(problem, chain, {.tolerance = std::numeric_limits<double>::quiet_NaN()}),
        std::invalid_argument);
}

}  // namespace
}  // namespace asv::core
