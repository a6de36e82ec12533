#include "io/problem/many_steps.hpp"

#include <string>

#include <gtest/gtest.h>

namespace asv::io {
namespace {

/// A point that has so far to go.
core::Problem point_with_way(double length, double step) {
    core::Problem problem{{{0, 0}}, {{length, 0}}, {}, {}, core::PointBody{}};
    problem.requirements.max_step = step;
    return problem;
}

/// The step that the warning tells.
double told_step(const std::string& warning) {
    const std::string before = "(a \"step\" of ";
    return std::stod(warning.substr(warning.find(before) + before.size()));
}

TEST(ManySteps, TellTheStepThatWouldFit) {
    for (const double length : {3e-7, 1.0, 99.9, 100.1, 200.0, 201.0, 1e6, 5.01e40}) {
        core::Problem problem = point_with_way(length, length / 1.1e5);
        const auto why = why_so_many_steps(problem);
        ASSERT_TRUE(why) << length;
        const double step = told_step(*why);
        problem.requirements.max_step = step;
        EXPECT_FALSE(why_so_many_steps(problem)) << *why;
        // Not much more than what is needed.
        EXPECT_LE(step, 2.5 * 1.001 * length / 1e5) << *why;
    }
}

TEST(ManySteps, AreMoreThanAHundredThousand) {
    EXPECT_FALSE(why_so_many_steps(point_with_way(1e5, 1)));
    EXPECT_FALSE(why_so_many_steps(point_with_way(0, 1e-300)));
    EXPECT_EQ(why_so_many_steps(point_with_way(150'000, 1)),
              "any path has 150000 steps of 1 or more (a \"step\" of 2 would fit): the goal is "
              "150000 away");
}

TEST(ManySteps, OfAnArmTellNoStepThatItsLinksForbid) {
    core::Problem problem = point_with_way(20, 1e-5);
    core::PlanarArm arm;
    arm.links = {10, 1e-4};
    problem.body = arm;
    EXPECT_EQ(why_so_many_steps(problem),
              "any path has 2e+06 steps of 1e-05 or more: the goal is 20 away");
    arm.links = {10, 1};
    problem.body = arm;
    EXPECT_EQ(told_step(*why_so_many_steps(problem)), 2e-4);
}

}  // namespace
}  // namespace asv::io
