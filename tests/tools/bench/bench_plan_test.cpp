#include "tools/bench/bench_plan.hpp"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kit/files/error_message.hpp"

/// What --planner may be, and what is said where it may not.

namespace asv::tools {
namespace {

using Words = std::vector<std::string>;

TEST(ParsePlanner, TakesALabelOrIsCalledWhatItIs) {
    const std::vector<std::array<std::string, 2>> labels{
        {"auto", "auto"},
        {"  rrt   step=0.02 ", "rrt step=0.02"},
        {"small steps: rrt step=0.02", "small steps"},
        {"a:b:rrt", "a:b"},
        {":rrt", "rrt"},
        {"exec cp {problem} {solution}", "exec cp {problem} {solution}"},
        {"copy it: exec cp {problem} {solution}", "copy it"},
        {"a:b: exec cp {problem} {solution}", "a:b"},
        {": exec cp {problem} {solution}", "exec cp {problem} {solution}"}};
    for (const auto& [text, label] : labels) EXPECT_EQ(parse_planner(text).label, label) << text;
}

TEST(ParsePlanner, KeepsTheWordsOfACommand) {
    EXPECT_EQ(parse_planner("exec cp {problem} {solution} 'two words'").command,
              (Words{"cp", "{problem}", "{solution}", "two words"}));
}

TEST(ParsePlanner, SaysWhatIsWrong) {
    const std::vector<std::array<std::string, 2>> mistakes{
        {"rrt\x1b[2J", "--planner: there is a control character in it"},
        {"rrt step", "--planner wants [LABEL:] NAME [KEY=VALUE]..., not 'step'"},
        {"exec ", "--planner exec : there is no command"},
        {"exec cp {solution}", "--planner exec cp {solution}: {problem} does not stand in it"},
        {"exec cp {problem}", "--planner exec cp {problem}: {solution} does not stand in it"},
        {"exec no-such-program {problem} {solution}",
         "--planner exec no-such-program {problem} {solution}: there is no program "
         "'no-such-program' that can be run"},
        // A file, but no program.
        {"exec /proc/version {problem} {solution}",
         "--planner exec /proc/version {problem} {solution}: there is no program '/proc/version' "
         "that can be run"}};
    for (const auto& mistake : mistakes)
        EXPECT_EQ(test::error_message<UsageError>([&] { parse_planner(mistake[0]); }), mistake[1]);
}

TEST(ParsePlanners, AllOfThemHaveNamesOfTheirOwn) {
    EXPECT_EQ(parse_planners({"rrt", "again: rrt"}).size(), 2U);
    EXPECT_EQ(test::error_message<UsageError>([] {
                  parse_planners({"rrt", "all"});
              }),
              "two planners are called 'rrt'; give one a label: \"LABEL: NAME KEY=VALUE\"");
}

}  // namespace
}  // namespace asv::tools
