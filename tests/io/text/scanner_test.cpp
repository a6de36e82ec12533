#include "io/text/scanner.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace asv::io {
namespace {

std::optional<double> number_in(std::string_view text) {
    return Scanner(text, "f").number();
}

constexpr std::uint64_t no_end = std::numeric_limits<std::uint64_t>::max();

std::optional<std::uint64_t> count_in(std::string_view text, std::uint64_t least = 0,
                                      std::uint64_t most = no_end) {
    return Scanner(text, "f").count(least, most);
}

TEST(Scanner, ReadsEveryCommonSpellingOfANumber) {
    EXPECT_EQ(number_in("0.25"), 0.25);
    EXPECT_EQ(number_in("-0.25"), -0.25);
    EXPECT_EQ(number_in("+0.25"), 0.25);
    EXPECT_EQ(number_in(".25"), 0.25);
    EXPECT_EQ(number_in("1."), 1.0);
    EXPECT_EQ(number_in("25e-2"), 0.25);
    EXPECT_EQ(number_in("2.5E+1"), 25.0);
    EXPECT_EQ(number_in(" \t\v\f 7"), 7.0);
    EXPECT_EQ(number_in("0.1"), 0.1);
    EXPECT_EQ(number_in("4.9e-324"), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(number_in("1e70"), 1e70);
}

TEST(Scanner, RefusesWhatIsNoNumber) {
    for (const char* text :
         {"",         " ",    "\n1", "x",     "nan", "NaN",   "-nan",  "inf",    "-inf",
          "infinity", "+inf", "1e",  "1e+",   "0x1", "0x1p3", "0,5",   "1.2.3",  "--1",
          "+-1",      "-+1",  "++1", "+",     "-",   ".",     "1e999", "-1e999", "1.1e70",
          "\r1",      "1d0",  "1f",  "\"1\"", "1;",  "0.25a", "1_000"}) {
        EXPECT_FALSE(number_in(text)) << text;
    }
    EXPECT_FALSE(number_in(std::string_view("1\0", 2)));
}

TEST(Scanner, CountsAreWholeNumbersOfAtLeastTheGivenSize) {
    EXPECT_EQ(count_in("3"), 3U);
    EXPECT_EQ(count_in("+3"), 3U);
    EXPECT_EQ(count_in("007"), 7U);
    EXPECT_EQ(count_in("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(count_in("0"), 0U);
    EXPECT_FALSE(count_in("0", 1));
    EXPECT_EQ(count_in("5", 1, 5), 5U);
    EXPECT_FALSE(count_in("6", 1, 5));
    for (const char* text :
         {"-1", "-0", "3.0", "1e5", "0x3", "18446744073709551616", "three", ""}) {
        EXPECT_FALSE(count_in(text)) << text;
    }
}

TEST(Scanner, AFailedReadDoesNotMove) {
    Scanner scanner("0 x", "f");
    EXPECT_FALSE(scanner.count(1, 9));
    EXPECT_EQ(scanner.number(), 0.0);
    EXPECT_FALSE(scanner.number());
    EXPECT_EQ(scanner.error("a number").column(), 3U);
}

TEST(Scanner, KnowsLinesAndColumns) {
    Scanner scanner("1 2\r\n\t3\n\n  4", "name");
    EXPECT_TRUE(scanner.number());
    EXPECT_FALSE(scanner.at_line_end());
    EXPECT_TRUE(scanner.number());
    EXPECT_TRUE(scanner.at_line_end());
    EXPECT_FALSE(scanner.number());
    scanner.next_line();
    EXPECT_EQ(scanner.error("it").line(), 2U);
    EXPECT_EQ(scanner.error("it").column(), 2U);
    scanner.next_line();
    EXPECT_TRUE(scanner.at_line_end());
    EXPECT_FALSE(scanner.at_end());
    scanner.next_line();
    EXPECT_EQ(scanner.number(), 4.0);
    EXPECT_TRUE(scanner.at_end());
    scanner.next_line();
    EXPECT_EQ(scanner.line(), 4U);
    EXPECT_EQ(std::string(scanner.error("more").what()),
              "name:4:4: expected more, found end of file");
}

TEST(Scanner, ShowsWhatItFound) {
    const auto found = [](std::string_view text) { return Scanner(text, "f").error("it").found(); };
    EXPECT_EQ(found("abc def"), "\"abc\"");
    EXPECT_EQ(found("1e999"), "\"1e999\" (out of range)");
    EXPECT_EQ(found("-1e300"), "\"-1e300\" (out of range)");
    EXPECT_EQ(found("nan"), "\"nan\" (not a number)");
    EXPECT_EQ(found("\x01\xFFz"), "\"\\x01\\xFFz\"");
    EXPECT_EQ(found(std::string(50, 'a')), "\"" + std::string(40, 'a') + "...\"");
    EXPECT_EQ(found(""), "end of file");
    EXPECT_EQ(found("  \n x"), "end of line");
    EXPECT_EQ(found("  \n \t"), "end of file");
}

TEST(Scanner, StepsOverAByteOrderMark) {
    Scanner scanner(
        "\xEF\xBB\xBF"
        "3",
        "f");
    EXPECT_EQ(scanner.error("it").column(), 1U);
    EXPECT_EQ(scanner.count(1, 9), 3U);
    const auto warnings = scanner.take_warnings();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(to_text(warnings[0]), "f:1:1: warning: byte order mark ignored");
    EXPECT_TRUE(Scanner("3", "f").take_warnings().empty());
}

TEST(Scanner, WhatIsTooSmallForANumberIsZeroWithAWarning) {
    Scanner scanner("1e-400 -1e-999 1e400", "f");
    EXPECT_EQ(scanner.number(), 0.0);
    EXPECT_EQ(scanner.number(), 0.0);
    EXPECT_FALSE(scanner.number());
    const auto warnings = scanner.take_warnings();
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(to_text(warnings[0]),
              "f:1:1: warning: \"1e-400\" is too small for a number and counts as 0");
    EXPECT_EQ(warnings[1].column, 8U);
}

TEST(Scanner, ALoneCarriageReturnEndsALineWithAWarning) {
    Scanner scanner("1\r2\r\n3\r\r\n4\r5", "f");
    for (std::size_t line = 1; line <= 5; ++line) {
        EXPECT_EQ(scanner.line(), line);
        EXPECT_EQ(scanner.number(), static_cast<double>(line));
        EXPECT_TRUE(scanner.at_line_end());
        scanner.next_line();
    }
    const auto warnings = scanner.take_warnings();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(to_text(warnings[0]),
              "f:1:2: warning: a lone carriage return ends this line (and 1 more lines)");
}

TEST(Scanner, TellsWhatIsLeftOnALine) {
    Scanner scanner("1 two\x1b \"three\" 4\n5 \n6 7", "f");
    EXPECT_TRUE(scanner.number());
    scanner.leave_line([] { return std::string("the first number"); });
    EXPECT_TRUE(scanner.number());
    scanner.leave_line([] { return std::string("nobody asks"); });
    EXPECT_TRUE(scanner.number());
    scanner.leave_line([] { return std::string("the last"); });
    EXPECT_TRUE(scanner.at_end());
    const auto warnings = scanner.take_warnings();
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(to_text(warnings[0]),
              "f:1:3: warning: ignored after the first number: \"two\\x1B\" and 2 more words");
    EXPECT_EQ(to_text(warnings[1]), "f:3:3: warning: ignored after the last: \"7\"");
    EXPECT_TRUE(scanner.take_warnings().empty());
}

TEST(Scanner, RequireNumberExplainsWhatIsMissing) {
    Scanner scanner("1 x", "f");
    EXPECT_EQ(scanner.require_number([] { return std::string("the first"); }), 1.0);
    try {
        scanner.require_number([] { return std::string("the second"); });
        FAIL() << "no error";
    } catch (const ParseError& error) {
        EXPECT_EQ(error.file(), "f");
        EXPECT_EQ(error.line(), 1U);
        EXPECT_EQ(error.column(), 3U);
        EXPECT_EQ(error.expected(), "the second");
        EXPECT_EQ(error.found(), "\"x\"");
    }
}

}  // namespace
}  // namespace asv::io
