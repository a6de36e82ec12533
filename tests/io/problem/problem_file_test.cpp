#include "io/problem/problem_file.hpp"

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

const std::string head = "3\n0 0 0.05 0 0.05 0.05\n1 0 1.05 0 1.05 0.05\n";
const std::string one = head + "1\n";

std::vector<std::string> warnings_of(const std::string& text) {
    std::vector<std::string> messages;
    for (const Warning& warning : parse_problem(text, "p").warnings) {
        messages.push_back(to_text(warning));
    }
    return messages;
}

std::string error_of(const std::string& text) {
    return test::error_message<ParseError>([&] { parse_problem(text, "p"); });
}

TEST(ProblemFile, ReadsWhatIsThere) {
    const ProblemFile file = parse_problem(head + "2\n0 1 2 1 2 3 0 3\n5 5 6 5 6 7 5 7\n", "p");
    const core::Problem& problem = file.problem;
    EXPECT_TRUE(file.warnings.empty());
    EXPECT_EQ(problem.start, (std::vector<core::Point>{{0, 0}, {0.05, 0}, {0.05, 0.05}}));
    EXPECT_EQ(problem.goal, (std::vector<core::Point>{{1, 0}, {1.05, 0}, {1.05, 0.05}}));
    EXPECT_EQ(problem.obstacles, (std::vector<core::Box>{{{0, 1}, {2, 3}}, {{5, 5}, {6, 7}}}));
}

TEST(ProblemFile, WhiteSpaceOfAnyKindIsNoReasonForAWarning) {
    const core::Problem expected = parse_problem(one + "0 1 2 1 2 3 0 3\n", "p").problem;
    for (const std::string text :
         {"3\r\n0 0 0.05 0 0.05 0.05\r\n1 0 1.05 0 1.05 0.05\r\n1\r\n0 1 2 1 2 3 0 3\r\n",
          "3\n0\t0\t0.05\t0 0.05 0.05\t\n  1 0   1.05 0 1.05 0.05 \n1 \n0 1 2 1 2 3 0 3",
          "+3\n0 0 0.05 0 0.05 0.05\n1 0 1.05 0 1.05 0.05\n1\n0 1 2 1 2 3 0 3 \n\n \r\n\t\n"}) {
        const ProblemFile file = parse_problem(text, "p");
        EXPECT_TRUE(file.warnings.empty()) << text;
        EXPECT_EQ(file.problem.start, expected.start);
        EXPECT_EQ(file.problem.goal, expected.goal);
        EXPECT_EQ(file.problem.obstacles, expected.obstacles);
    }
}

TEST(ProblemFile, TakesWhatItNeedsFromTheFrontOfEachLine) {
    const std::string text = "1 ASV\n0 0 5 5 6 6\n1 1 goal\n1 # obstacle\n2 2 3 2 3 3 2 3 9\nbye\n";
    const core::Problem problem = parse_problem(text, "p").problem;
    EXPECT_EQ(problem.start, (std::vector<core::Point>{{0, 0}}));
    EXPECT_EQ(problem.goal, (std::vector<core::Point>{{1, 1}}));
    EXPECT_EQ(problem.obstacles, (std::vector<core::Box>{{{2, 2}, {3, 3}}}));
    EXPECT_EQ(warnings_of(text),
              (std::vector<std::string>{
                  "p:1:3: warning: ignored after the number of ASVs: \"ASV\"",
                  "p:2:5: warning: ignored after ASV 1, the last one of the start: \"5\" and 3 "
                  "more words",
                  "p:3:5: warning: ignored after ASV 1, the last one of the goal: \"goal\"",
                  "p:4:3: warning: ignored after the number of obstacles: \"#\" and 1 more word",
                  "p:5:17: warning: ignored after the fourth corner of obstacle 1: \"9\"",
                  "p:6:1: warning: ignored: what follows the last of 1 obstacle"}));
}

TEST(ProblemFile, ReadsLonelyCarriageReturnsAndTinyNumbers) {
    const std::string text = "1\r0 1e-400\r1 1\n0\n";
    EXPECT_EQ(parse_problem(text, "p").problem.start, (std::vector<core::Point>{{0, 0}}));
    EXPECT_EQ(warnings_of(text),
              (std::vector<std::string>{
                  "p:2:3: warning: \"1e-400\" is too small for a number and counts as 0",
                  "p:1:2: warning: a lone carriage return ends this line (and 1 more lines)"}));
}

TEST(ProblemFile, WarnsAboutWallsThatVanishWithinTheTolerance) {
    const auto line = [](const std::string& x) {
        return one + "0.5 0 " + x + " 0 " + x + " 1 0.5 1";
    };
    EXPECT_EQ(warnings_of(line("0.5")),
              (std::vector<std::string>{"p:5:1: warning: obstacle 1 is 0 wide, less than twice the "
                                        "tolerance of 1e-05, and vanishes"}));
    EXPECT_EQ(warnings_of(line("0.500019")).size(), 1U);
    EXPECT_TRUE(warnings_of(line("0.500021")).empty());
    EXPECT_TRUE(parse_problem(line("0.5"), "p", {.tolerance = 0}).warnings.empty());
    EXPECT_EQ(parse_problem(line("0.51"), "p", {.tolerance = 0.01}).warnings.size(), 1U);
}

TEST(ProblemFile, TheObstacleIsTheBoundingBoxOfItsCorners) {
    const auto box_of = [](const std::string& line) {
        return parse_problem(one + line, "p").problem.obstacles.at(0);
    };
    const core::Box box{{0, 1}, {2, 3}};
    for (const char* line : {"0 1 2 1 2 3 0 3", "2 3 0 3 0 1 2 1", "0 1 0 3 2 3 2 1",
                             "0 1 2 1 2 3 2 3", "1 1 2 2 1 3 0 2"}) {
        EXPECT_EQ(box_of(line), box) << line;
    }
}

TEST(ProblemFile, WarnsAboutOddCorners) {
    EXPECT_EQ(warnings_of(one + "2 3 0 3 0 1 2 1"),
              (std::vector<std::string>{
                  "p:5:1: warning: obstacle 1: corners are not counter-clockwise from "
                  "the lower left; their bounding box is the obstacle"}));
    EXPECT_EQ(warnings_of(one + "0 1 2 1 2 3 2 3"),
              (std::vector<std::string>{"p:5:1: warning: obstacle 1: a corner is given twice; the "
                                        "bounding box is the obstacle"}));
    EXPECT_EQ(
        warnings_of(one + "1 1 2 2 1 3 0 2"),
        (std::vector<std::string>{"p:5:1: warning: obstacle 1: corners are not those of an upright "
                                  "rectangle; their bounding box is the obstacle"}));
    EXPECT_EQ(warnings_of(one + "0 1 2 1 2 1 0 1"),
              (std::vector<std::string>{"p:5:1: warning: obstacle 1 is 0 high, less than twice the "
                                        "tolerance of 1e-05, and vanishes"}));
}

TEST(ProblemFile, WarnsAboutContentAfterTheLastObstacle) {
    EXPECT_EQ(
        warnings_of(one + "0 1 2 1 2 3 0 3\n\n\nremark"),
        (std::vector<std::string>{"p:8:1: warning: ignored: what follows the last of 1 obstacle"}));
}

TEST(ProblemFile, WarnsAboutAByteOrderMark) {
    EXPECT_EQ(warnings_of("\xEF\xBB\xBF" + head + "0\n"),
              (std::vector<std::string>{"p:1:1: warning: byte order mark ignored"}));
}

TEST(ProblemFile, ListsNoMoreThanAHundredWarnings) {
    std::string text = head + "250\n";
    for (int i = 0; i < 250; ++i) text += "1 1 0 0 1 0 0 1\n";
    const std::vector<std::string> messages = warnings_of(text);
    ASSERT_EQ(messages.size(), 100U);
    EXPECT_NE(messages.back().find("(150 further warnings are not listed)"), std::string::npos);
}

TEST(ProblemFile, ErrorsNameThePlaceAndWhatWasDue) {
    EXPECT_EQ(
        error_of(""),
        "p:1:1: expected the number of ASVs (a whole number from 1 to 100000), found end of file");
    EXPECT_EQ(error_of("0\n"),
              "p:1:1: expected the number of ASVs (a whole number from 1 to 100000), found \"0\"");
    EXPECT_EQ(error_of("2\n0 0 1\n"),
              "p:2:6: expected a number (y of ASV 2 of the start), found end of file");
    EXPECT_EQ(error_of("1\n0 0\n\n0\n"),
              "p:3:1: expected a number (x of ASV 1 of the goal), found end of line");
    EXPECT_EQ(
        error_of(head + "-1\n"),
        "p:4:1: expected the number of obstacles (a whole number from 0 to 2000000), found \"-1\"");
    EXPECT_EQ(error_of(head + "2000000\n"),
              "p:5:1: expected obstacle 1 of 2000000, found end of file");
    EXPECT_EQ(error_of(one + "0 0 1 0 1 1 0\n"),
              "p:5:14: expected a number (y of corner 4 of obstacle 1), found end of file");
}

TEST(ProblemFile, ACountThatPromisesTooMuchCostsNothing) {
    EXPECT_EQ(error_of("100000\n0 0\n"),
              "p:2:4: expected a number (x of ASV 2 of the start), found end of file");
    EXPECT_EQ(error_of("100001\n0 0\n"),
              "p:1:1: expected the number of ASVs (a whole number from 1 to 100000), found "
              "\"100001\"");
    EXPECT_EQ(error_of(head + "2000001\n"),
              "p:4:1: expected the number of obstacles (a whole number from 0 to 2000000), found "
              "\"2000001\"");
}

TEST(ProblemFile, NamesTheFileThatIsMissing) {
    EXPECT_THROW(read_problem("/nonexistent/p.txt"), ReadError);
    const test::TemporaryFolder folder;
    std::ofstream(folder / "p.txt") << "x";
    try {
        read_problem(folder / "p.txt");
        FAIL() << "no error";
    } catch (const ParseError& error) {
        EXPECT_EQ(error.file(), (folder / "p.txt").string());
    }
}

}  // namespace
}  // namespace asv::io
