#include <numbers>
#include <string>

#include "core/chain/arm_kinematics.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/solving.hpp"

/// Tolerances below what coordinates are rounded by.

namespace asv::core {
namespace {

Problem without_tolerance(Problem problem) {
    problem.requirements.tolerance = 0;
    return problem;
}

void expect_no_coordinates_keep_it(const Problem& problem) {
    const SolveResult result = solve(problem, test::plain(1));
    EXPECT_EQ(result.status, SolveStatus::timeout);
    EXPECT_FALSE(result.solution);
    EXPECT_NE(result.reason.find("do not keep a tolerance of 0: "), std::string::npos)
        << result.reason;
}

TEST(SmallTolerance, APointAndALoneAsvKeepZero) {
    Problem problem = without_tolerance(test::problem({{0.89, 0.87}}, {{0.26, 0.41}}));
    for (const Body& body : {Body(PointBody{}), Body(AsvChain{})}) {
        problem.body = body;
        const SolveResult result = solve(problem, test::plain(1));
        ASSERT_EQ(result.status, SolveStatus::solved) << result.reason;
        EXPECT_TRUE(validate(problem, *result.solution, {.tolerance = 0}).valid());
    }
}

TEST(SmallTolerance, BroomsAreRoundedByMoreThanZero) {
    // The ends have brooms of exactly this length; what is between them has not.
    Problem problem = without_tolerance(
        test::problem({{0, 0}, {0.5, 0}, {0.5, 0.5}}, {{2, 2}, {2, 2.5}, {1.5, 2.5}}));
    problem.requirements.broom_length = 0.5;
    problem.requirements.max_step = 0.01;
    problem.requirements.bounds = without_bounds();
    expect_no_coordinates_keep_it(problem);
}

TEST(SmallTolerance, LinksAreRoundedByMoreThanZero) {
    PlanarArm arm;
    arm.links = {0.5};
    arm.joints = {{.wraps = true}};
    arm.start = {0};
    arm.goal = {std::numbers::pi};
    Problem problem = without_tolerance({});
    problem.start = arm_points(arm, {0, 0}, arm.start);
    problem.goal = arm_points(arm, {0, 0}, arm.goal);
    problem.requirements.max_step = 0.01;
    problem.requirements.bounds = without_bounds();
    problem.body = arm;
    expect_no_coordinates_keep_it(problem);
}

}  // namespace
}  // namespace asv::core
