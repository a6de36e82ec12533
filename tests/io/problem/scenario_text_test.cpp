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

}  // namespace
}  // namespace asv::io
