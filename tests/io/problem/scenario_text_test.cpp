#include "io/problem/scenario_text.hpp"

#include <string>

#include <gtest/gtest.h>

#include "io/problem/problem_file.hpp"
#include "io/problem/scenario_file.hpp"
#include "tests/kit/chains/problems.hpp"

namespace asv::io {
namespace {

TEST(FormatScenario, ReadsBackToTheSameNumbers) {
    for (const char* file : {"7ASV.txt", "bodies/arm-3-workshop.json", "bodies/arm-3-plane.json",
                             "bodies/arm-4-map.json", "bodies/point-town.json"}) {
        const core::Problem problem = read_problem(test::testcase_file(file)).problem;
        const std::string text = format_scenario(problem);
        const core::Problem again = parse_scenario(text, file, "").problem;
        EXPECT_EQ(format_scenario(again), text) << file;
        EXPECT_EQ(again.start.size(), problem.start.size()) << file;
        EXPECT_EQ(again.obstacles.size(), problem.obstacles.size()) << file;
        EXPECT_EQ(again.start.back().x, problem.start.back().x) << file;
        EXPECT_EQ(again.goal.back().y, problem.goal.back().y) << file;
        EXPECT_EQ(again.requirements.max_step, problem.requirements.max_step) << file;
        EXPECT_EQ(again.requirements.bounded(), problem.requirements.bounded()) << file;
    }
}

TEST(FormatScenario, TellsTheMotionLimitsThatItKnows) {
    core::Problem problem = read_problem(test::testcase_file("3ASV.txt")).problem;
    EXPECT_EQ(format_scenario(problem).find("limits"), std::string::npos);
    for (const core::MotionLimits& limits :
         {core::MotionLimits{{1.5}, {0.25, 1, 2}}, core::MotionLimits{{}, {3}}}) {
        problem.motion_limits = limits;
        const std::string text = format_scenario(problem);
        EXPECT_EQ(parse_scenario(text, "s.json", "").problem.motion_limits, limits) << text;
    }
}

}  // namespace
}  // namespace asv::io
