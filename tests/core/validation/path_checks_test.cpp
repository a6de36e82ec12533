#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"
#include "tests/core/validation/tolerance.hpp"
#include "tests/kit/chains/paths.hpp"
#include "tests/kit/check_results.hpp"

/// The checks of a whole path, and what the report says.

namespace asv::core {
namespace {

using test::Case;
using test::Points;
using Checks = std::vector<Check>;

constexpr double bit = 1e-9;

/// The corner goes right by 0.0005 ten times.
std::vector<Points> slide() {
    std::vector<Points> states;
    for (int i = 0; i <= 10; ++i) states.push_back(test::moved(test::corner(), 0.0005 * i, 0));
    return states;
}

ValidationReport report(const Case& path, ValidationOptions options = {}) {
    return validate(path.problem, path.solution, options);
}

Checks failures(const Case& path) {
    return test::failed(report(path).checks);
}

TEST(ValidatePath, AGoodPathMeetsEveryRequirement) {
    const ValidationReport result = report(test::case_of(slide()));
    EXPECT_TRUE(result.valid());
    ASSERT_EQ(result.checks.size(), check_count);
    for (std::size_t i = 0; i < check_count; ++i) {
        EXPECT_EQ(result.checks[i].check, static_cast<Check>(i));
        EXPECT_TRUE(result.checks[i].ok());
    }
    EXPECT_EQ(test::find(result.checks, Check::ends).states, 2U);
    EXPECT_EQ(test::find(result.checks, Check::steps).states, 10U);
    EXPECT_EQ(test::find(result.checks, Check::cost).states, 1U);
    EXPECT_EQ(test::find(result.checks, Check::area).states, 11U);
    EXPECT_NEAR(test::find(result.checks, Check::steps).worst.value().room, 0.00051, 1e-12);
    EXPECT_NEAR(result.cost, 10 * 3 * 0.0005, 1e-12);
    EXPECT_TRUE(result.motion.empty());
}

TEST(ValidatePath, OneStateIsAPathWithoutSteps) {
    const ValidationReport result = report(test::case_of({test::corner()}));
    EXPECT_TRUE(result.valid());
    EXPECT_EQ(test::find(result.checks, Check::steps).states, 0U);
    EXPECT_EQ(describe(test::find(result.checks, Check::steps)), "nothing to check");
}

TEST(ValidatePath, ACostIsRightWithinTheRoundingOfTheSum) {
    Case path = test::case_of(slide());
    const auto cost_is_right = [&](double cost, double tolerance) {
        path.solution.cost = cost;
        return test::find(report(path, {.tolerance = tolerance}).checks, Check::cost).ok();
    };
    const double cost = path.solution.cost, last_bit = std::nextafter(cost, 1) - cost;
    EXPECT_TRUE(cost_is_right(cost + last_bit, 0));
    EXPECT_TRUE(cost_is_right(cost - last_bit, 0));
    EXPECT_FALSE(cost_is_right(cost + 100 * last_bit, 0));
    EXPECT_TRUE(cost_is_right(cost + e - bit, e));
    EXPECT_FALSE(cost_is_right(cost + e + bit, e));
}

TEST(ValidatePath, EndsMayBeOffByTheTolerance) {
    for (const bool goal : {false, true}) {
        for (const double off : {e - bit, e + bit}) {
            Case path = test::case_of(slide());
            (goal ? path.problem.goal : path.problem.start)[2].y += off;
            EXPECT_EQ(failures(path), off > e ? Checks{Check::ends} : Checks{});
            const Offender worst = *test::find(report(path).checks, Check::ends).worst;
            EXPECT_EQ(worst.state, goal ? 10U : 0U);
            EXPECT_EQ(worst.asv, 2U);
            EXPECT_NEAR(worst.room, e - off, 1e-12);
        }
    }
}

TEST(ValidatePath, EndsAreMeasuredInAStraightLine) {
    Case path = test::case_of(slide());
    path.problem.start[0] = {path.problem.start[0].x + 0.8 * e, path.problem.start[0].y + 0.7 * e};
    EXPECT_EQ(failures(path), Checks{Check::ends});
}

TEST(ValidatePath, StepsMayExceedTheirLengthByTheTolerance) {
    for (const double length : {0.001 + e - bit, 0.001 + e + bit}) {
        std::vector<Points> states = slide();
        states.push_back(test::moved(states.back(), 0, length));
        const Case path = test::case_of(states);
        EXPECT_EQ(failures(path), length > 0.001 + e ? Checks{Check::steps} : Checks{});
        const Offender worst = *test::find(report(path).checks, Check::steps).worst;
        EXPECT_EQ(worst.state, 11U);
        EXPECT_TRUE(worst.asv);
    }
}

TEST(ValidatePath, TheCostMayBeOffByTheTolerance) {
    for (const double off : {-e - bit, -e + bit, e - bit, e + bit}) {
        Case path = test::case_of(slide());
        path.solution.cost += off;
        EXPECT_EQ(failures(path), std::abs(off) > e ? Checks{Check::cost} : Checks{}) << off;
    }
}

TEST(ValidatePath, EveryStateIsChecked) {
    for (const std::size_t broken : {0U, 4U, 10U}) {
        std::vector<Points> states = slide();
        states[broken][0].x -= 0.0001;
        const ValidationReport result = report(test::case_of(states));
        EXPECT_EQ(test::failed(result.checks), Checks{Check::broom_lengths});
        const CheckResult& lengths = test::find(result.checks, Check::broom_lengths);
        EXPECT_EQ(lengths.failures, 1U);
        EXPECT_EQ(lengths.worst.value().state, broken);
    }
}

TEST(ValidatePath, TheWorstOffenderIsTheOneWithTheLeastRoom) {
    Case path = test::case_of(slide());
    // The corner's upright broom enters the first box at the end and the second one deeper.
    path.problem.obstacles = {{{0.554, 0.54}, {0.6, 0.6}}, {{0.552, 0.51}, {0.6, 0.53}}};
    const CheckResult result = test::find(report(path).checks, Check::collisions);
    EXPECT_EQ(result.failures, 6U);
    const Offender worst = result.worst.value();
    EXPECT_EQ(worst.state, 10U);
    EXPECT_EQ(worst.broom, 1U);
    EXPECT_EQ(worst.obstacle, 1U);
    EXPECT_NEAR(worst.room, -0.00299, 1e-12);
    EXPECT_EQ(describe(result), "broom 2 meets obstacle 2 by 0.00299");
}

TEST(ValidatePath, OffendersAreListedOnRequest) {
    Case path = test::case_of(slide());
    path.problem.obstacles = {{{0.552, 0.51}, {0.6, 0.53}}};
    EXPECT_TRUE(test::find(report(path).checks, Check::collisions).offenders.empty());
    const ValidationReport listed = report(path, {.list_offenders = true});
    const CheckResult& result = test::find(listed.checks, Check::collisions);
    ASSERT_EQ(result.offenders.size(), result.failures);
    for (std::size_t i = 0; i < result.offenders.size(); ++i) {
        EXPECT_EQ(result.offenders[i].state, 5 + i);
        EXPECT_LE(result.offenders[i].room, 0);
    }
    EXPECT_TRUE(test::find(listed.checks, Check::area).offenders.empty());
}

TEST(ValidatePath, RefusesArgumentsWithoutMeaning) {
    Case path = test::case_of(slide());
    EXPECT_THROW(validate(path.problem, Solution{Path(3), 0}), std::invalid_argument);
    path.problem.start.pop_back();
    EXPECT_THROW(report(path), std::invalid_argument);
    path = test::case_of(slide());
    EXPECT_THROW(report(path, {.tolerance = -1e-9}), std::invalid_argument);
    EXPECT_THROW(report(path, {.tolerance = std::numeric_limits<double>::infinity()}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace asv::core
