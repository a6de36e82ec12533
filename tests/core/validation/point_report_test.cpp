#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"
#include "tests/kit/check_results.hpp"

namespace asv::core {
namespace {

/// A point that moves to the right in two steps, in an empty square.
struct Sample {
    Problem problem;
    Solution solution{Path(1), 0.002};
};

Sample sample() {
    Sample result;
    result.problem.body = PointBody{};
    result.problem.start = {{0.1, 0.5}};
    result.problem.goal = {{0.102, 0.5}};
    for (const double x : {0.1, 0.101, 0.102})
        result.solution.path.push_back(std::vector<Point>{{x, 0.5}});
    return result;
}

TEST(ValidatePoint, MustNotTouchObstacles) {
    auto [problem, solution] = sample();
    EXPECT_TRUE(validate(problem, solution, {.continuous = true}).valid());
    problem.obstacles = {{{0.1009, 0.4}, {0.1011, 0.6}}};
    const auto report = validate(problem, solution, {.continuous = true});
    EXPECT_FALSE(report.valid());
    EXPECT_EQ(describe(report.checks.back()), "the point meets obstacle 1 by 9e-05");
    // A lone ASV has no broom that could collide.
    problem.body = AsvChain{};
    for (const CheckResult& check : validate(problem, solution, {}).checks)
        EXPECT_TRUE(check.ok() || check.check != Check::collisions);
    // Between two states.
    problem.body = PointBody{};
    problem.obstacles = {{{0.1004, 0.4}, {0.1006, 0.6}}};
    EXPECT_TRUE(validate(problem, solution, {}).valid());
    EXPECT_FALSE(validate(problem, solution, {.continuous = true}).valid());
}

TEST(ValidatePoint, APlaceThatIsNotFiniteFailsItsStateAndBothSteps) {
    auto [problem, solution] = sample();
    Path path(1);
    for (const double x : {0.1, std::numeric_limits<double>::quiet_NaN(), 0.102})
        path.push_back(std::vector<Point>{{x, 0.5}});
    solution.path = path;
    const auto report = validate(problem, solution, {.continuous = true});
    for (const Check check : {Check::bounds, Check::collisions}) {
        EXPECT_EQ(test::find(report.checks, check).failures, 1U);
        EXPECT_EQ(test::find(report.motion, check).failures, 2U);
    }
}

TEST(ValidatePoint, AStateAloneIsJudgedByBoundsAndObstacles) {
    Problem problem = sample().problem;
    EXPECT_TRUE(validate_state(problem, problem.start, {}).valid());
    problem.obstacles = {{{0, 0.4}, {0.2, 0.6}}};
    const std::vector<Point> outside = {{-0.1, 0.7}};
    EXPECT_EQ(test::failed(validate_state(problem, problem.start, {}).checks),
              std::vector{Check::collisions});
    EXPECT_EQ(test::failed(validate_state(problem, outside, {}).checks),
              std::vector{Check::bounds});
}

}  // namespace
}  // namespace asv::core
