#include "io/text/scanner.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace asv::io {
namespace {

std::optional<double> number_in(std::string_view text) {
    return Scanner(text, "f").number();
}

std::optional<std::uint64_t> count_in(std::string_view text, std::uint64_t least = 0) {
    return Scanner(text, "f").count(least);
}

TEST(Scanner, ReadsEveryCommonSpellingOfANumber) {
    EXPECT_EQ(number_in("0.25"), 0.25);
    EXPECT_EQ(number_in("-0.25"), -0.25);
    EXPECT_EQ(number_in("+0.25"), 0.25);
    EXPECT_EQ(number_in(".25"), 0.25);
    EXPECT_EQ(number_in("1."), 1.0);
    EXPECT_EQ(number_in("25e-2"), 0.25);
    EXPECT_EQ(number_in("2.5E+1"), 25.0);
    EXPECT_EQ(number_in(" \t\v\f\r 7"), 7.0);
    EXPECT_EQ(number_in("0.1"), 0.1);
    EXPECT_EQ(number_in("4.9e-324"), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(number_in("1e70"), 1e70);
}

TEST(Scanner, RefusesWhatIsNoNumber) {
    for (const char* text :
         {"",         " ",    "\n1", "x",     "nan", "NaN",   "-nan",  "inf",    "-inf",
          "infinity", "+inf", "1e",  "1e+",   "0x1", "0x1p3", "0,5",   "1.2.3",  "--1",
          "+-1",      "-+1",  "++1", "+",     "-",   ".",     "1e999", "-1e999", "1.1e70",
          "1e-999",   "1d0",  "1f",  "\"1\"", "1;",  "0.25a", "1_000"}) {
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
    for (const char* text :
         {"-1", "-0", "3.0", "1e5", "0x3", "18446744073709551616", "three", ""}) {
        EXPECT_FALSE(count_in(text)) << text;
    }
}

TEST(Scanner, AFailedReadDoesNotMove) {
    Scanner scanner("0 x", "f");
    EXPECT_FALSE(scanner.count(1));
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
    EXPECT_TRUE(scanner.had_byte_order_mark());
    EXPECT_EQ(scanner.error("it").column(), 1U);
    EXPECT_EQ(scanner.count(1), 3U);
    EXPECT_FALSE(Scanner("3", "f").had_byte_order_mark());
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
