#include "tests/kit/files/malformed_files.hpp"

#include <cstddef>
#include <utility>

namespace asv::test {
namespace {

using Lines = std::vector<std::string>;

const std::string asv_count =
    "expected the number of ASVs (a whole number from 1 to 100000), found ";
const std::string obstacle_count =
    "expected the number of obstacles (a whole number from 0 to 2000000), found ";

/// The good lines with one of them, counted from 1, replaced.
std::string with_line(Lines lines, std::size_t number, const std::string& line) {
    lines[number - 1] = line;
    return joined(lines);
}

std::string first_lines(Lines lines, std::size_t count) {
    lines.resize(count);
    return joined(lines);
}

std::string problem_with(std::size_t line, const std::string& text) {
    return with_line(good_problem(), line, text);
}

std::string solution_with(std::size_t line, const std::string& text) {
    return with_line(good_solution(), line, text);
}

std::string bytes(const char* text, std::size_t size) {
    return {text, size};
}

std::vector<Malformed> other_formats() {
    return {
        {"empty", "", "1:1: " + asv_count + "end of file"},
        {"one line end", "\n", "1:1: " + asv_count + "end of file"},
        {"blanks", " \t \r\n \n", "1:4: " + asv_count + "end of file"},
        {"zero bytes", bytes("\0\0\0\0", 4), "1:1: " + asv_count + "\"\\x00\\x00\\x00\\x00\""},
        {"program",
         bytes("\x7F"
               "ELF\x02\x01\x01\0",
               8),
         "1:1: " + asv_count + "\"\\x7FELF"},
        {"picture", "\x89PNG\r\n\x1A\n", "1:1: " + asv_count + "\"\\x89PNG\""},
        {"archive", "\x1F\x8B\x08", "1:1: " + asv_count + "\"\\x1F\\x8B\\x08\""},
        {"UTF-16",
         bytes("\xFF\xFE"
               "3\0\n\0",
               6),
         "1:1: " + asv_count + "\"\\xFF\\xFE3\\x00\""},
        {"web page", "<!DOCTYPE html>\n", "1:1: " + asv_count + "\"<!DOCTYPE\""},
        {"JSON that is no scenario", "{\"n\": 3}\n", "1:1: expected a member at version"},
        {"JSON with a member given twice", "{\"version\": 1,\n \"version\": 1}\n",
         "2:2: expected each member once, found \"version\" again"},
        {"JSON with a member given twice in other letters", "{\"a\": 1, \"\\u0061\": 1}\n",
         "1:10: expected each member once, found \"a\" again"},
        {"JSON with the name of a member that would write on a terminal",
         R"({"version":1,"body":{},"start":[],"goal":[],"\u001b[31mRED\u0007":1})",
         "1:1: expected no other members than version, body, start, goal, unit, bounds, obstacles, "
         "map, step, tolerance, limits at \\x1B[31mRED\\x07, found 1"},
        {"JSON of brackets", "{\"a\":" + std::string(66'000, '[') + std::string(66'000, ']') + "}",
         "1:69: expected at most 64 brackets inside each other, found one more"},
        {"JSON of brackets that are open", "{\"a\":" + std::string(200'000, '['),
         "1:69: expected at most 64 brackets inside each other, found one more"},
    };
}

std::vector<Malformed> broken_asv_counts() {
    return {
        {"count is a word", problem_with(1, "three"), "1:1: " + asv_count + "\"three\""},
        {"count is zero", problem_with(1, "0"), "1:1: " + asv_count + "\"0\""},
        {"count is negative", problem_with(1, "-3"), "1:1: " + asv_count + "\"-3\""},
        {"count is a fraction", problem_with(1, "3.0"), "1:1: " + asv_count + "\"3.0\""},
        {"count has an exponent", problem_with(1, "3e0"), "1:1: " + asv_count + "\"3e0\""},
        {"count is hexadecimal", problem_with(1, "0x3"), "1:1: " + asv_count + "\"0x3\""},
        {"count is huge", problem_with(1, "99999999999999999999"),
         "1:1: " + asv_count + "\"99999999999999999999\""},
        {"count is not a number", problem_with(1, "nan"), "1:1: " + asv_count + "\"nan\""},
        {"count with comma", problem_with(1, "3,"), "1:1: " + asv_count + "\"3,\""},
        {"count is missing", problem_with(1, ""), "1:1: " + asv_count + "end of line"},
        {"more ASVs than positions", problem_with(1, "4"),
         "2:29: expected a number (x of ASV 4 of the start), found end of line"},
        {"more ASVs than are read", problem_with(1, "100001"), "1:1: " + asv_count + "\"100001\""},
        {"more ASVs than memory", problem_with(1, "1000000000"),
         "1:1: " + asv_count + "\"1000000000\""},
        {"as many ASVs as are read", problem_with(1, "100000"),
         "2:29: expected a number (x of ASV 4 of the start), found end of line"},
    };
}

std::vector<Malformed> broken_positions() {
    const std::string x1 = "2:1: expected a number (x of ASV 1 of the start), found ";
    const std::string y1 = "2:6: expected a number (y of ASV 1 of the start), found ";
    const auto with_y1 = [](const std::string& text) {
        return problem_with(2, "0.15 " + text + " 0.15 0.15 0.2 0.15");
    };
    return {
        {"start is missing", first_lines(good_problem(), 1), x1 + "end of file"},
        {"start is an empty line", problem_with(2, ""), x1 + "end of line"},
        {"start is too short", problem_with(2, "0.15 0.2 0.15 0.15"),
         "2:19: expected a number (x of ASV 3 of the start), found end of line"},
        {"start ends in the middle of a position", problem_with(2, "0.15 0.2 0.15"),
         "2:14: expected a number (y of ASV 2 of the start), found end of line"},
        {"coordinate is not a number", with_y1("nan"), y1 + "\"nan\" (not a number)"},
        {"coordinate is -nan", with_y1("-nan"), y1 + "\"-nan\" (not a number)"},
        {"coordinate is infinite", with_y1("inf"), y1 + "\"inf\" (out of range)"},
        {"coordinate is -infinity", with_y1("-Infinity"), y1 + "\"-Infinity\" (out of range)"},
        {"coordinate overflows", with_y1("1e999"), y1 + "\"1e999\" (out of range)"},
        {"coordinate is huge", with_y1("-1e300"), y1 + "\"-1e300\" (out of range)"},
        {"coordinate with comma", with_y1("0,2"), y1 + "\"0,2\""},
        {"coordinate is hexadecimal", with_y1("0x1"), y1 + "\"0x1\""},
        {"coordinate without exponent", with_y1("2e"), y1 + "\"2e\""},
        {"coordinate is a word", with_y1("O.2"), y1 + "\"O.2\""},
        {"coordinate with two points", with_y1("0.2.1"), y1 + "\"0.2.1\""},
        {"coordinate with two signs", with_y1("+-0.2"), y1 + "\"+-0.2\""},
        {"coordinate is a sign", with_y1("-"), y1 + "\"-\""},
        {"coordinate with typographic minus",
         with_y1("\xE2\x88\x92"
                 "0.2"),
         y1 + "\"\\xE2\\x88\\x920.2\""},
        {"coordinate with zero byte", with_y1(bytes("0.2\0", 4)), y1 + "\"0.2\\x00\""},
        {"coordinate without end", with_y1(std::string(100'000, '9')),
         y1 + "\"9999999999999999999999999999999999999999...\" (out of range)"},
        {"goal is missing", first_lines(good_problem(), 2),
         "3:1: expected a number (x of ASV 1 of the goal), found end of file"},
        {"goal is an empty line", problem_with(3, " "),
         "3:2: expected a number (x of ASV 1 of the goal), found end of line"},
        {"goal is too short", problem_with(3, "0.85 0.2 0.8 0.2 0.8"),
         "3:21: expected a number (y of ASV 3 of the goal), found end of line"},
        {"goal has a word", problem_with(3, "0.85 0.2 goal"),
         "3:10: expected a number (x of ASV 2 of the goal), found \"goal\""},
    };
}

std::vector<Malformed> broken_obstacles() {
    const auto obstacle = [](const std::string& text) { return problem_with(5, text); };
    const std::string one = "0.4 0 0.6 0 0.6 0.1 ";
    return {
        {"obstacle count is missing", first_lines(good_problem(), 3),
         "4:1: " + obstacle_count + "end of file"},
        {"obstacle count is an empty line", problem_with(4, ""),
         "4:1: " + obstacle_count + "end of line"},
        {"obstacle count is a word", problem_with(4, "one"), "4:1: " + obstacle_count + "\"one\""},
        {"obstacle count is negative", problem_with(4, "-1"), "4:1: " + obstacle_count + "\"-1\""},
        {"obstacle count is a fraction", problem_with(4, "1.5"),
         "4:1: " + obstacle_count + "\"1.5\""},
        {"obstacle count is not a number", problem_with(4, "nan"),
         "4:1: " + obstacle_count + "\"nan\""},
        {"obstacle count is huge", problem_with(4, "18446744073709551616"),
         "4:1: " + obstacle_count + "\"18446744073709551616\""},
        {"obstacles without a count", problem_with(4, good_problem()[4]),
         "4:1: " + obstacle_count + "\"0.4\""},
        {"an obstacle is missing", problem_with(4, "2"),
         "6:1: expected obstacle 2 of 2, found end of file"},
        {"10^9 obstacles, one present", problem_with(4, "1000000000"),
         "4:1: " + obstacle_count + "\"1000000000\""},
        {"2 * 10^6 obstacles, one present", problem_with(4, "2000000"),
         "6:1: expected obstacle 2 of 2000000, found end of file"},
        {"2^64 - 1 obstacles", problem_with(4, "18446744073709551615"),
         "4:1: " + obstacle_count + "\"18446744073709551615\""},
        {"a corner is missing", obstacle(one),
         "5:21: expected a number (x of corner 4 of obstacle 1), found end of file"},
        {"seven numbers", obstacle(one + "0.4"),
         "5:24: expected a number (y of corner 4 of obstacle 1), found end of file"},
        {"corner is not a number", obstacle(one + "0.4 nan"),
         "5:25: expected a number (y of corner 4 of obstacle 1), found \"nan\" (not a number)"},
        {"corner is infinite", obstacle(one + "inf 0.1"),
         "5:21: expected a number (x of corner 4 of obstacle 1), found \"inf\" (out of range)"},
        {"corner is huge", obstacle("1e308 0 0.6 0 0.6 0.1 0.4 0.1"),
         "5:1: expected a number (x of corner 1 of obstacle 1), found \"1e308\" (out of range)"},
        {"corner is a word", obstacle("left 0 0.6 0 0.6 0.1 0.4 0.1"),
         "5:1: expected a number (x of corner 1 of obstacle 1), found \"left\""},
        {"corners with commas", obstacle("0.4, 0, 0.6, 0, 0.6, 0.1, 0.4, 0.1"),
         "5:1: expected a number (x of corner 1 of obstacle 1), found \"0.4,\""},
        {"corners in brackets", obstacle("(0.4 0) (0.6 0) (0.6 0.1) (0.4 0.1)"),
         "5:1: expected a number (x of corner 1 of obstacle 1), found \"(0.4\""},
        {"an empty line between obstacles", problem_with(4, "2") + "\n" + good_problem()[4] + "\n",
         "6:1: expected a number (x of corner 1 of obstacle 2), found end of line"},
    };
}

}  // namespace

Lines good_problem() {
    return {"3", "0.15 0.2 0.15 0.15 0.2 0.15 ", "0.15 0.2004 0.15 0.1504 0.2 0.1504", "1",
            "0.4 0 0.6 0 0.6 0.1 0.4 0.1"};
}

Lines good_solution() {
    return {"1 0.0012", "0.15 0.2 0.15 0.15 0.2 0.15", "0.15 0.2004 0.15 0.1504 0.2 0.1504"};
}

std::string joined(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

std::vector<Malformed> malformed_problems() {
    std::vector<Malformed> all = other_formats();
    for (const auto& group : {broken_asv_counts(), broken_positions(), broken_obstacles()}) {
        all.insert(all.end(), group.begin(), group.end());
    }
    return all;
}

std::vector<Malformed> malformed_solutions() {
    const std::string steps =
        "1:1: expected the number of primitive steps (a whole number from 0 to 16666665), found ";
    const std::string cost = "expected a number (the total cost), found ";
    return {
        {"empty", "", steps + "end of file"},
        {"binary",
         bytes("\x7F"
               "ELF\0",
               5),
         steps + "\"\\x7FELF\\x00\""},
        {"steps are a word", solution_with(1, "one 0.0012"), steps + "\"one\""},
        {"steps are negative", solution_with(1, "-1 0.0012"), steps + "\"-1\""},
        {"steps are a fraction", solution_with(1, "1.0 0.0012"), steps + "\"1.0\""},
        {"steps are missing", solution_with(1, ""), steps + "end of line"},
        {"cost is missing", solution_with(1, "1"), "1:2: " + cost + "end of line"},
        {"cost is not a number", solution_with(1, "1 nan"),
         "1:3: " + cost + "\"nan\" (not a number)"},
        {"cost is infinite", solution_with(1, "1 inf"), "1:3: " + cost + "\"inf\" (out of range)"},
        {"a state is missing", solution_with(1, "2 0.0012"),
         "4:1: expected state 2 of 0 to 2, found end of file"},
        {"10^9 states, two present", solution_with(1, "1000000000 0.0012"),
         steps + "\"1000000000\""},
        {"10^7 states, two present", solution_with(1, "10000000 0.0012"),
         "4:1: expected state 2 of 0 to 10000000, found end of file"},
        {"no state", first_lines(good_solution(), 1),
         "2:1: expected state 0 of 0 to 1, found end of file"},
        {"a position is missing", solution_with(2, "0.15 0.2 0.15 0.15"),
         "2:19: expected a number (x of ASV 3 in state 0), found end of line"},
        {"an empty line", solution_with(2, ""),
         "2:1: expected a number (x of ASV 1 in state 0), found end of line"},
        {"coordinate is a word", solution_with(3, "0.15 y"),
         "3:6: expected a number (y of ASV 1 in state 1), found \"y\""},
        {"coordinate is not a number", solution_with(3, "NaN 0.2004 0.15 0.1504 0.2 0.1504"),
         "3:1: expected a number (x of ASV 1 in state 1), found \"NaN\" (not a number)"},
        {"coordinate is huge", solution_with(3, "1e99 0.2004 0.15 0.1504 0.2 0.1504"),
         "3:1: expected a number (x of ASV 1 in state 1), found \"1e99\" (out of range)"},
    };
}

}  // namespace asv::test
