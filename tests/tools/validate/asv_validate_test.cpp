#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/malformed_files.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

/// What a user of asv-validate sees.

namespace asv::test {
namespace {

using Words = std::vector<std::string>;

Outcome validate(const Words& arguments, const Surroundings& surroundings = {}) {
    return run_program("asv-validate", arguments, surroundings);
}

class ValidateProgram : public testing::Test {
  protected:
    std::string write(const std::string& name, const std::string& content) const {
        io::write_file(folder_ / name, content);
        return (folder_ / name).string();
    }

    TemporaryFolder folder_;
    std::string problem_ = write("p", joined(good_problem()));
    std::string solution_ = write("s", joined(good_solution()));
    /// ASV 2 of the last state is 0.0001 too far left, which is wrong in many ways.
    std::string broken_ = write("b", joined({good_solution()[0], good_solution()[1],
                                             "0.15 0.2004 0.1499 0.1504 0.2 0.1504"}));
};

TEST_F(ValidateProgram, PrintsOneLineForEachCheckInOrder) {
    const Outcome outcome = validate({problem_, solution_});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    const Words printed = lines_of(outcome.out);
    const Words expected = {
        "ends +ok +2 states: room 1e-05 at ASV 1 \\(state 0, line 2\\)",
        "steps +ok +1 step: room 0.00061 at ASV [123] \\(state 1, line 3\\)",
        "cost +ok +room 1e-05 \\(line 1\\)",
        "broom lengths +ok +2 states: room 1e-05 at broom [12] \\(state [01], line [23]\\)",
        "convexity +ok +2 states: room 0.785 at ASV [13] \\(state [01], line [23]\\)",
        "area +ok +2 states: room 0.000644 \\(state [01], line [23]\\)",
        "bounds +ok +2 states: room 0.15 at ASV [12] \\(state [01], line [23]\\)",
        "collisions +ok +2 states: room 0.206 at broom 2, obstacle 1 \\(state 0, line 2\\)",
        "valid"};
    ASSERT_EQ(printed.size(), expected.size()) << outcome.out;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_TRUE(std::regex_match(printed[i], std::regex(expected[i]))) << printed[i];
    }
}

TEST_F(ValidateProgram, NamesTheWorstOffender) {
    const Outcome outcome = validate({problem_, broken_});
    EXPECT_EQ(outcome.exit_code, 1);
    const Words printed = lines_of(outcome.out);
    ASSERT_EQ(printed.size(), 9U);
    EXPECT_TRUE(std::regex_match(
        printed[0], std::regex("ends +FAILED  1 of 2 states: ASV 2 misses its place by 9e-05 "
                               "\\(state 1, line 3\\)")))
        << printed[0];
    EXPECT_TRUE(std::regex_match(
        printed[3], std::regex("broom lengths +FAILED  1 of 2 states: broom 2 is 0.0501 long, 0.05 "
                               "within 1e-5 is wanted \\(state 1, line 3\\)")))
        << printed[3];
    EXPECT_EQ(printed.back(), "not valid");
}

TEST_F(ValidateProgram, ListsEveryViolationWhenVerbose) {
    const std::string two =
        write("two", joined({"2 0", good_solution()[1], "0.15 0.2 0.1499 0.15 0.2 0.15",
                             "0.15 0.2004 0.1498 0.1504 0.2 0.1504"}));
    const std::string out = validate({problem_, two, "--verbose"}).out;
    EXPECT_NE(out.find("\n    state 2, line 4: broom 2 is 0.0502 long, 0.05 within 1e-5"),
              std::string::npos)
        << out;
    EXPECT_NE(out.find("\n    state 1, line 3: broom 2 is 0.0501 long, 0.05 within 1e-5"),
              std::string::npos)
        << out;
    EXPECT_EQ(validate({problem_, two}).out.find("    state"), std::string::npos);
}

TEST_F(ValidateProgram, ChecksStartAndGoalWithoutASolution) {
    const Outcome outcome = validate({problem_});
    EXPECT_EQ(outcome.exit_code, 0);
    const Words printed = lines_of(outcome.out);
    ASSERT_EQ(printed.size(), 13U);
    EXPECT_EQ(printed[0], "start");
    EXPECT_EQ(printed[6], "goal");
    EXPECT_NE(printed[1].find("(line 2)"), std::string::npos);
    EXPECT_NE(printed[7].find("(line 3)"), std::string::npos);
    EXPECT_EQ(printed.back(), "valid");
    EXPECT_EQ(validate({testcase_file("invalid/goal-winds-twice.txt")}).exit_code, 1);
}

TEST_F(ValidateProgram, IsAsLenientAsItIsTold) {
    EXPECT_EQ(validate({problem_, broken_, "--tolerance", "0.001"}).exit_code, 0);
    EXPECT_EQ(validate({problem_, broken_, "--tolerance", "0.00009"}).exit_code, 1);
    EXPECT_EQ(validate({problem_, solution_, "--tolerance", "0"}).exit_code, 1);
}

TEST_F(ValidateProgram, CertifiesTheMotionOnRequest) {
    Words thin = good_problem();
    thin[3] = "2";
    thin.push_back("0.17 0.1501 0.18 0.1501 0.18 0.1503 0.17 0.1503");
    const std::string problem = write("thin", joined(thin));
    EXPECT_EQ(validate({problem, solution_}).exit_code, 0);
    const Outcome outcome = validate({problem, solution_, "--continuous"});
    EXPECT_EQ(outcome.exit_code, 1);
    const Words printed = lines_of(outcome.out);
    ASSERT_EQ(printed.size(), 14U);
    const Words names = {"broom lengths", "convexity", "area", "bounds", "collisions"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(printed[8 + i].find("motion: " + names[i]), 0U) << printed[8 + i];
    }
    EXPECT_TRUE(std::regex_match(
        printed[12], std::regex("motion: collisions +FAILED  1 of 1 step: broom 2 meets obstacle "
                                "2 by [0-9.e-]+ \\(on the way to state 1, line 3\\)")))
        << printed[12];
    EXPECT_EQ(validate({problem_, solution_, "--continuous"}).exit_code, 0);
}

TEST_F(ValidateProgram, WritesWhatItFoundAsJson) {
    const std::string file = (folder_ / "j").string();
    EXPECT_EQ(validate({problem_, broken_, "--continuous", "--json", file}).exit_code, 1);
    const nlohmann::json json = nlohmann::json::parse(io::read_file(file));
    EXPECT_EQ(json["problem"], problem_);
    EXPECT_EQ(json["solution"], broken_);
    EXPECT_EQ(json["valid"], false);
    ASSERT_EQ(json["parts"].size(), 1U);
    EXPECT_EQ(json["parts"][0]["checks"].size(), 8U);
    EXPECT_EQ(json["parts"][0]["motion"].size(), 5U);
    EXPECT_EQ(json["parts"][0]["checks"][0]["worst"]["line"], 3);
}

TEST_F(ValidateProgram, WarningsGoToStandardErrorUnlessItIsToBeQuiet) {
    Words quirky = good_problem();
    quirky[1] += " 0.3 0.3";
    const std::string problem = write("quirky", joined(quirky));
    const Outcome outcome = validate({problem});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, problem +
                               ":2:30: warning: ignored after ASV 3, the last one of the start: "
                               "\"0.3\" and 1 more word\n");
    EXPECT_EQ(validate({problem, "--quiet"}).err, "");
}

TEST_F(ValidateProgram, WrongUsageIsExplained) {
    for (const Words& wrong : std::vector<Words>{{},
                                                 {"--unknown"},
                                                 {problem_, solution_, "third"},
                                                 {problem_, "--tolerance"},
                                                 {problem_, "--tolerance", "-1"},
                                                 {problem_, "--tolerance", "nan"},
                                                 {problem_, "--tolerance", "inf"},
                                                 {problem_, "--tolerance", "1e-5x"},
                                                 {problem_, "--tolerance", "1", "--tolerance", "2"},
                                                 {problem_, "--continuous"}}) {
        const Outcome outcome = validate(wrong);
        EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(wrong);
        EXPECT_EQ(outcome.err.find("asv-validate: "), 0U) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
}

TEST_F(ValidateProgram, HelpsAndTellsItsVersion) {
    const Outcome help = validate({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.err, "");
    for (const char* part : {"PROBLEM", "SOLUTION", "--tolerance", "--continuous", "--json",
                             "--verbose", "--quiet", "--version", "Example:"}) {
        EXPECT_NE(help.out.find(part), std::string::npos) << part;
    }
    const Outcome version = validate({"--version"});
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_TRUE(std::regex_match(version.out, std::regex("asv-validate [0-9.]+\n")));
}

TEST_F(ValidateProgram, AStandardOutputThatIsFullIsAnError) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    for (const Words& arguments : std::vector<Words>{{problem_}, {"--help"}}) {
        const Outcome outcome = validate(arguments, {.standard_output = "/dev/full"});
        EXPECT_EQ(outcome.exit_code, 5);
        EXPECT_EQ(outcome.err, "asv-validate: standard output cannot be written\n");
    }
}

TEST_F(ValidateProgram, JsonMayGoToStandardOutput) {
    const Outcome outcome = validate({problem_, solution_, "--json", "/dev/stdout"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.out.find("valid\n"), std::string::npos);
    EXPECT_NE(outcome.out.find("\"problem\""), std::string::npos);
}

TEST(ValidateTestcases, StartsAndGoalsOfAllSolvableProblemsAreValid) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(testcase_file(""))) {
        if (entry.path().extension() != ".txt") continue;
        const Outcome outcome = validate({entry.path().string(), "--tolerance", "1e-9"});
        EXPECT_EQ(outcome.exit_code, 0) << entry.path() << '\n' << outcome.out << outcome.err;
        ++files;
    }
    EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace asv::test
