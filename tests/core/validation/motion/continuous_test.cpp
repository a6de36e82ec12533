#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"
#include "tests/core/validation/tolerance.hpp"
#include "tests/kit/chains/paths.hpp"
#include "tests/kit/check_results.hpp"

/// What may go wrong between two states that are both in order.

namespace asv::core {
namespace {

using std::numbers::pi;
using test::Case;
using test::chain_with_turns;
using test::Points;
using Checks = std::vector<Check>;

ValidationReport certified(const Case& path, double tolerance = e) {
    return validate(path.problem, path.solution, {.tolerance = tolerance, .continuous = true});
}

Checks motion_failures(const std::vector<Points>& states, const std::vector<Box>& boxes = {},
                       double tolerance = e) {
    Case path = test::case_of(states);
    path.problem.obstacles = boxes;
    return test::failed(certified(path, tolerance).motion);
}

/// The chain with two ASVs turned about the middle between them by an angle.
Points spun(double angle) {
    const double dx = 0.025 * std::cos(angle);
    const double dy = 0.025 * std::sin(angle);
    return {{0.5 - dx, 0.5 - dy}, {0.5 + dx, 0.5 + dy}};
}

TEST(Motion, AGoodPathIsCertified) {
    std::vector<Points> states;
    for (int i = 0; i <= 10; ++i) {
        states.push_back(chain_with_turns({0.4 + 0.0005 * i, 0.4}, 0.004 * i, {0.8, 0.0, 0.9}));
    }
    const ValidationReport report = certified(test::case_of(states));
    EXPECT_TRUE(report.valid());
    ASSERT_EQ(report.motion.size(), 5U);
    for (const CheckResult& result : report.motion) EXPECT_EQ(result.states, 10U);
    EXPECT_EQ(report.motion[0].check, Check::broom_lengths);
    EXPECT_EQ(report.motion[4].check, Check::collisions);
}

TEST(Motion, AStateThatStaysIsCertified) {
    EXPECT_EQ(motion_failures({test::corner(), test::corner()}), Checks{});
}

TEST(Motion, AViolationSomewhereSpoilsTheReport) {
    Case path = test::case_of({test::corner(), test::corner()});
    path.problem.obstacles = {{{0.4, 0.4}, {0.6, 0.6}}};
    const ValidationReport report = certified(path);
    EXPECT_EQ(test::failed(report.motion), Checks{Check::collisions});
    EXPECT_FALSE(report.valid());
}

TEST(Motion, ATurningBroomIsShorterOnTheWay) {
    // Half-way the length is 0.05 * cos(angle / 2).
    const double angle_at_limit = 2 * std::acos(1 - e / 0.05);
    const auto lengths_of = [](double angle) {
        return test::find(certified(test::case_of({spun(0.3), spun(0.3 + angle)})).motion,
                          Check::broom_lengths);
    };
    EXPECT_TRUE(lengths_of(0.9999 * angle_at_limit).ok());
    const CheckResult result = lengths_of(1.0001 * angle_at_limit);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.worst.value().broom, 0U);
    EXPECT_EQ(result.worst.value().state, 1U);
    EXPECT_NEAR(result.worst.value().time.value(), 0.5, 1e-6);
    EXPECT_LT(result.worst.value().room, 0);
    EXPECT_NEAR(lengths_of(0.02).worst.value().room, e - 0.05 * (1 - std::cos(0.01)), 1e-12);
}

TEST(Motion, NoBroomIsTooShortForAToleranceOfItsLength) {
    const Case half_a_turn = test::case_of({spun(0.3), spun(0.3 + pi)});
    const auto lengths_within = [&](double tolerance) {
        return test::find(certified(half_a_turn, tolerance).motion, Check::broom_lengths);
    };
    EXPECT_FALSE(lengths_within(0.049).ok());
    EXPECT_TRUE(lengths_within(0.05).ok());
}

TEST(Motion, ABroomThatIsTooLongAtAnEndFails) {
    Points longer = test::corner();
    longer[2].y += 2 * e;
    EXPECT_EQ(motion_failures({test::corner(), longer}), Checks{Check::broom_lengths});
    EXPECT_EQ(motion_failures({longer, test::corner()}), Checks{Check::broom_lengths});
    EXPECT_EQ(motion_failures({longer, test::corner()}, {}, 3 * e), Checks{});
}

TEST(Motion, AnObstacleThatIsJumpedOverIsFound) {
    Case path = test::case_of({test::corner(), test::moved(test::corner(), 0.001, 0)});
    path.problem.obstacles = {{{0.1, 0.1}, {0.2, 0.2}}, {{0.5503, 0.51}, {0.5506, 0.54}}};
    const ValidationReport report = certified(path);
    EXPECT_EQ(test::failed(report.checks), Checks{});
    EXPECT_EQ(test::failed(report.motion), Checks{Check::collisions});
    const Offender worst = *test::find(report.motion, Check::collisions).worst;
    EXPECT_EQ(worst.state, 1U);
    EXPECT_EQ(worst.broom, 1U);
    EXPECT_EQ(worst.obstacle, 1U);
    EXPECT_GT(worst.time.value(), 0.3);
    EXPECT_LT(worst.time.value(), 0.6);
    EXPECT_LT(worst.room, -1e-5);
}

TEST(Motion, ACornerThatIsCutIsFound) {
    // The lower end of the upright broom goes diagonally past the corner of a box.
    const auto passing = [](double corner) {
        return motion_failures({test::corner(), test::moved(test::corner(), 0.0006, -0.0006)},
                               {{{0.4, 0.4}, {corner + e, corner - 0.05 + e}}}, e);
    };
    EXPECT_EQ(passing(0.5497), Checks{Check::collisions});
    // A box above the lower broom and left of the upright one is passed on the outside.
    const Points before = {{0.5, 0.5}, {0.5, 0.55}, {0.45, 0.55}};
    const Points after = test::moved(before, 0.0006, -0.0006);
    const auto inside = [&](double reach) {
        return motion_failures({before, after},
                               {{{0.46, 0.51}, {0.5 + reach + e, 0.55 - 0.0006 + reach + e}}});
    };
    EXPECT_EQ(inside(-1e-9), Checks{});
    EXPECT_EQ(inside(1e-9), Checks{Check::collisions});
}

TEST(Motion, AnObstacleRightBesideTheWayIsPassed) {
    const double tolerance = std::ldexp(1.0, -17);
    const auto beside = [&](double gap) {
        Case path = test::case_of({test::corner(), test::moved(test::corner(), 0.0009, 0)});
        path.problem.obstacles = {{{0.2, 0.2}, {0.8, 0.5 - gap + tolerance}}};
        return test::failed(certified(path, tolerance).motion);
    };
    EXPECT_EQ(beside(1e-12), Checks{});
    EXPECT_EQ(beside(0), Checks{Check::collisions});
}

TEST(Motion, AStraightClosingTurnMayBendBackOnTheWay) {
    // ASV 6, 1 and 2 are in line before and after, but the line turns while the closing side
    // shrinks or grows: one of the two bends the wrong way in between.
    const auto state = [](double angle, double closing) {
        const Point along{std::cos(angle), std::sin(angle)};
        return Points{{0.5, 0.5},   {0.5 + 0.05 * along.x, 0.5 + 0.05 * along.y},
                      {0.55, 0.55}, {0.5, 0.55},
                      {0.45, 0.55}, {0.5 - closing * along.x, 0.5 - closing * along.y}};
    };
    const auto convexity_of = [&](double closing) {
        const ValidationReport report =
            certified(test::case_of({state(0, 0.05), state(0.03, closing)}));
        EXPECT_TRUE(test::find(report.checks, Check::convexity).ok());
        return test::find(report.motion, Check::convexity);
    };
    EXPECT_TRUE(convexity_of(0.0485).ok());
    const CheckResult result = convexity_of(0.0515);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.worst.value().asv, 0U);
    EXPECT_NEAR(result.worst.value().time.value(), 0.5, 0.05);
    EXPECT_NEAR(result.worst.value().room, e - 0.0015 * 0.03 / 4 / 0.05, 1e-5);
}

TEST(Motion, TheClosingSideMayNotShrinkToAPoint) {
    const auto square = [](double gap) {
        return Points{{0.5, 0.5}, {0.55, 0.5}, {0.55, 0.55}, {0.5, 0.55}, {0.5 - gap, 0.5}};
    };
    const ValidationReport report = certified(test::case_of({square(0.0004), square(0)}));
    EXPECT_TRUE(test::find(report.checks, Check::convexity).ok());
    const CheckResult& result = test::find(report.motion, Check::convexity);
    EXPECT_EQ(describe(result), "the side after ASV 5 shrinks to a point");
    EXPECT_EQ(motion_failures({square(0.0004), square(0.0001)}), Checks{});
}

TEST(Motion, TwoWindingsFail) {
    const double turn = 0.8 * pi;
    const Points star = chain_with_turns({0.5, 0.5}, 0, {turn, turn, turn});
    const CheckResult result =
        test::find(certified(test::case_of({star, star})).motion, Check::convexity);
    ASSERT_FALSE(result.ok());
    EXPECT_FALSE(result.worst.value().asv);
    EXPECT_NEAR(result.worst.value().room, -pi, 1e-3);
}

TEST(Motion, TheAreaMayShrinkOnTheWay) {
    // A rigid turn by an angle about ASV 2 costs sin(angle / 2)^2 of the area half-way.
    const double least = pi * 0.014 * 0.014 - e;
    const double angle = 0.02;
    const auto area_of = [&](double area) {
        const double bend = std::asin(area / 0.00125);
        const auto turned = [&](double heading) {
            return Points{
                {0.5 - 0.05 * std::cos(heading), 0.5 - 0.05 * std::sin(heading)},
                {0.5, 0.5},
                {0.5 + 0.05 * std::cos(heading + bend), 0.5 + 0.05 * std::sin(heading + bend)}};
        };
        return test::find(certified(test::case_of({turned(1), turned(1 + angle)})).motion,
                          Check::area);
    };
    const double loss = least * std::sin(angle / 2) * std::sin(angle / 2);
    EXPECT_TRUE(area_of(least + 1.001 * loss).ok());
    const CheckResult result = area_of(least + 0.999 * loss);
    ASSERT_FALSE(result.ok());
    EXPECT_NEAR(result.worst.value().time.value(), 0.5, 1e-6);
    EXPECT_NEAR(area_of(least).worst.value().room, -loss, 1e-12);
}

TEST(Motion, BoundsHoldBetweenStatesThatAreInside) {
    const Points inside = test::moved(test::corner(), 0.449, 0);
    const Points outside = test::moved(test::corner(), 0.4501, 0);
    EXPECT_EQ(motion_failures({inside, test::moved(inside, 0.001, 0)}), Checks{});
    EXPECT_EQ(motion_failures({inside, outside}), Checks{Check::bounds});
    EXPECT_EQ(motion_failures({outside, inside}), Checks{Check::bounds});
    Case path = test::case_of({inside, outside});
    EXPECT_EQ(test::find(certified(path).motion, Check::bounds).worst.value().time, 1.0);
}

TEST(Motion, OneAsvOnlyHasBounds) {
    EXPECT_EQ(motion_failures({{{0.5, 0.5}}, {{0.501, 0.5}}}, {{{0.4, 0.4}, {0.6, 0.6}}}),
              Checks{});
    EXPECT_EQ(motion_failures({{{1, 0.5}}, {{1.001, 0.5}}}), Checks{Check::bounds});
}

TEST(Motion, TwoAsvsHaveNoArea) {
    EXPECT_EQ(motion_failures({spun(0), spun(0)}), (Checks{Check::convexity, Check::area}));
}

TEST(Motion, WhatIsNotFiniteFailsBothItsSteps) {
    std::vector<Points> states(4, test::corner());
    states[1][2].x = std::nan("");
    const ValidationReport report = certified(test::case_of(states));
    ASSERT_EQ(report.motion.size(), 5U);
    for (const CheckResult& result : report.motion) {
        EXPECT_EQ(result.states, 3U);
        EXPECT_EQ(result.failures, 2U);
    }
}

TEST(Motion, HugeCoordinatesFailWithoutHarm) {
    Points huge = test::corner();
    huge[1] = {1e70, -1e70};
    const Checks checks = motion_failures({test::corner(), huge}, {{{0.4, 0.4}, {0.6, 0.6}}});
    EXPECT_NE(std::find(checks.begin(), checks.end(), Check::broom_lengths), checks.end());
    EXPECT_NE(std::find(checks.begin(), checks.end(), Check::bounds), checks.end());
}

TEST(Motion, OffendersAreListedOnRequest) {
    std::vector<Points> states;
    for (int i = 0; i < 4; ++i) states.push_back(test::moved(test::corner(), 0.001 * i, 0));
    Case path = test::case_of(states);
    path.problem.obstacles = {{{0.5503, 0.51}, {0.5506, 0.54}}, {{0.5523, 0.51}, {0.5526, 0.54}}};
    const ValidationReport report =
        validate(path.problem, path.solution, {.continuous = true, .list_offenders = true});
    const CheckResult& result = test::find(report.motion, Check::collisions);
    ASSERT_EQ(result.offenders.size(), 2U);
    EXPECT_EQ(result.offenders[0].state, 1U);
    EXPECT_EQ(result.offenders[0].obstacle, 0U);
    EXPECT_EQ(result.offenders[1].state, 3U);
    EXPECT_EQ(result.offenders[1].obstacle, 1U);
}

}  // namespace
}  // namespace asv::core
