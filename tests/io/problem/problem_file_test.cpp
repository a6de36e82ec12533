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
        messages.push_back(warning.file + ":" + std::to_string(warning.line) + ": " +
                           warning.message);
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

TEST(ProblemFile, IgnoresFurtherPositionsWithAWarning) {
    const std::string text = "1\n0 0 5 5 6 6\n1 1 7\n0\n";
    EXPECT_EQ(parse_problem(text, "p").problem.start, (std::vector<core::Point>{{0, 0}}));
    EXPECT_EQ(warnings_of(text),
              (std::vector<std::string>{
                  "p:2: more than 1 positions for the start: the last 4 numbers ignored",
                  "p:3: more than 1 positions for the goal: the last 1 numbers ignored"}));
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
              (std::vector<std::string>{"p:5: obstacle 1: corners are not counter-clockwise from "
                                        "the lower left; their bounding box is the obstacle"}));
    EXPECT_EQ(warnings_of(one + "0 1 2 1 2 3 2 3"),
              (std::vector<std::string>{
                  "p:5: obstacle 1: a corner is given twice; the bounding box is the obstacle"}));
    EXPECT_EQ(warnings_of(one + "1 1 2 2 1 3 0 2"),
              (std::vector<std::string>{"p:5: obstacle 1: corners are not those of an upright "
                                        "rectangle; their bounding box is the obstacle"}));
    EXPECT_EQ(warnings_of(one + "0 1 2 1 2 1 0 1"),
              (std::vector<std::string>{"p:5: obstacle 1 has no area"}));
}

TEST(ProblemFile, WarnsAboutContentAfterTheLastObstacle) {
    EXPECT_EQ(warnings_of(one + "0 1 2 1 2 3 0 3\n\n\nremark"),
              (std::vector<std::string>{"p:8: content after the last of 1 obstacles ignored"}));
}

TEST(ProblemFile, WarnsAboutAByteOrderMark) {
    EXPECT_EQ(warnings_of("\xEF\xBB\xBF" + head + "0\n"),
              (std::vector<std::string>{"p:1: byte order mark ignored"}));
}

TEST(ProblemFile, ListsNoMoreThanAHundredWarnings) {
    std::string text = head + "250\n";
    for (int i = 0; i < 250; ++i) text += "1 1 0 0 1 0 0 1\n";
    const std::vector<std::string> messages = warnings_of(text);
    ASSERT_EQ(messages.size(), 100U);
    EXPECT_NE(messages.back().find("(150 further warnings are not listed)"), std::string::npos);
}

TEST(ProblemFile, ErrorsNameThePlaceAndWhatWasDue) {
    EXPECT_EQ(error_of(""),
              "p:1:1: expected the number of ASVs (a whole number, at least 1), found end of file");
    EXPECT_EQ(error_of("0\n"),
              "p:1:1: expected the number of ASVs (a whole number, at least 1), found \"0\"");
    EXPECT_EQ(error_of("3 x\n"), "p:1:3: expected nothing more on this line, found \"x\"");
    EXPECT_EQ(error_of("2\n0 0 1\n"),
              "p:2:6: expected a number (y of ASV 2 of the start), found end of file");
    EXPECT_EQ(error_of("1\n0 0\n\n0\n"),
              "p:3:1: expected a number (x of ASV 1 of the goal), found end of line");
    EXPECT_EQ(error_of("1\n0 0 x\n1 1\n0\n"),
              "p:2:5: expected a number or the end of the line, found \"x\"");
    EXPECT_EQ(error_of(head + "-1\n"),
              "p:4:1: expected the number of obstacles (a whole number, at least 0), found \"-1\"");
    EXPECT_EQ(error_of(head + "1000000000\n"),
              "p:5:1: expected obstacle 1 of 1000000000, found end of file");
    EXPECT_EQ(error_of(one + "0 0 1 0 1 1 0\n"),
              "p:5:14: expected a number (y of corner 4 of obstacle 1), found end of file");
    EXPECT_EQ(error_of(one + "0 0 1 0 1 1 0 1 9\n"),
              "p:5:17: expected nothing more after the fourth corner, found \"9\"");
}

TEST(ProblemFile, ACountThatPromisesTooMuchCostsNothing) {
    EXPECT_EQ(error_of("18446744073709551615\n0 0\n"),
              "p:2:4: expected a number (x of ASV 2 of the start), found end of file");
    EXPECT_EQ(error_of(head + "18446744073709551615\n"),
              "p:5:1: expected obstacle 1 of 18446744073709551615, found end of file");
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
