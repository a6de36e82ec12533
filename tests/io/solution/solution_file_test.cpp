#include "io/solution/solution_file.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

std::string error_of_solution(const std::string& text, std::size_t asv_count = 2) {
    return test::error_message<ParseError>([&] { parse_solution(text, asv_count, "s"); });
}

TEST(SolutionFile, ReadsStepsCostAndStates) {
    const core::Solution solution = parse_solution("1 0.25\r\n0 1 2 3\r\n4 5\t6 7 \r\n\n", 2, "s");
    EXPECT_EQ(solution.cost, 0.25);
    ASSERT_EQ(solution.path.size(), 2U);
    EXPECT_EQ(solution.path.state(0)[1], (geometry::Point{2, 3}));
    EXPECT_EQ(solution.path.state(1)[0], (geometry::Point{4, 5}));
}

TEST(SolutionFile, AnUnmovedChainHasNoSteps) {
    const core::Solution solution = parse_solution("0 0\n0 1", 1, "s");
    EXPECT_EQ(solution.path.size(), 1U);
}

TEST(SolutionFile, ErrorsNameThePlaceAndWhatWasDue) {
    EXPECT_EQ(error_of_solution(""),
              "s:1:1: expected the number of primitive steps (a whole number from 0 to 24999999), "
              "found end of file");
    EXPECT_EQ(error_of_solution("-1 0\n"),
              "s:1:1: expected the number of primitive steps (a whole number from 0 to 24999999), "
              "found \"-1\"");
    EXPECT_EQ(error_of_solution("1\n"),
              "s:1:2: expected a number (the total cost), found end of file");
    EXPECT_EQ(error_of_solution("1 nan\n"),
              "s:1:3: expected a number (the total cost), found \"nan\" (not a number)");
    EXPECT_EQ(error_of_solution("1 0\n0 0 1 1\n"),
              "s:3:1: expected state 1 of 0 to 1, found end of file");
    EXPECT_EQ(error_of_solution("1 0\n0 0 1\n"),
              "s:2:6: expected a number (y of ASV 2 in state 0), found end of file");
    EXPECT_EQ(error_of_solution("1 0\n\n0 0 1 1\n"),
              "s:2:1: expected a number (x of ASV 1 in state 0), found end of line");
}

TEST(SolutionFile, TakesWhatItNeedsAndTellsWhatItIgnores) {
    const std::string text = "1 0.25 m\r0 1 2 3 9 9\r\n4 5 6 7 9\n\nfound in 12 ms\n";
    std::vector<Warning> warnings;
    const core::Solution solution = parse_solution(text, 2, "s", &warnings);
    EXPECT_EQ(solution.cost, 0.25);
    ASSERT_EQ(solution.path.size(), 2U);
    EXPECT_EQ(solution.path.state(1)[1], (geometry::Point{6, 7}));
    std::vector<std::string> texts;
    for (const Warning& warning : warnings) texts.push_back(to_text(warning));
    EXPECT_EQ(texts,
              (std::vector<std::string>{
                  "s:1:8: warning: ignored after the total cost: \"m\"",
                  "s:2:9: warning: ignored after ASV 2, the last one of a state: \"9\" and 1 "
                  "more word (and so on 1 further lines)",
                  "s:5:1: warning: ignored: what follows state 1, the last one",
                  "s:1:9: warning: a lone carriage return ends this line"}));
    EXPECT_EQ(parse_solution(text, 2, "s").path.size(), 2U);
}

TEST(SolutionFile, ACountThatPromisesTooMuchCostsNothing) {
    EXPECT_EQ(error_of_solution("24999999 0\n0 0 1 1\n"),
              "s:3:1: expected state 1 of 0 to 24999999, found end of file");
    EXPECT_EQ(error_of_solution("25000000 0\n0 0 1 1\n"),
              "s:1:1: expected the number of primitive steps (a whole number from 0 to 24999999), "
              "found \"25000000\"");
}

TEST(SolutionFile, RefusesArgumentsWithoutMeaning) {
    EXPECT_THROW(parse_solution("0 0\n\n", 0, "s"), std::invalid_argument);
    EXPECT_THROW(write_solution("s", core::Solution{core::Path(2), 0}), std::invalid_argument);
}

TEST(SolutionFile, IsWrittenInTheShortestDigits) {
    const test::TemporaryFolder folder;
    core::Solution solution{core::Path(1), 0.5};
    solution.path.push_back(std::vector<geometry::Point>{{0.1, -0.0}});
    solution.path.push_back(std::vector<geometry::Point>{{1, 1e-300}});
    write_solution(folder / "s", solution);
    EXPECT_EQ(read_file(folder / "s"), "1 0.5\n0.1 -0\n1 1e-300\n");
}

}  // namespace
}  // namespace asv::io
