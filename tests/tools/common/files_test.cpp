#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/files/malformed_files.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

/// What all programs have in common about the files that they are given.

namespace asv::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const std::string point_scenario =
    R"({"version": 1, "body": {"kind": "point"}, "map": {"file": "m.map"}, "step": 0.1,
 "start": [0.5, 0.5], "goal": [1.5, 0.5]})";

class Files : public testing::Test {
  protected:
    std::string write(const std::string& name, const std::string& content) const {
        io::write_file(folder_ / name, content);
        return in(name);
    }
    std::string in(const std::string& name) const { return (folder_ / name).string(); }

    /// Exit code 2, a message that names both, and every file as it was.
    void expect_refused(const std::string& program, const Words& arguments) const {
        SCOPED_TRACE(program);
        const std::vector<std::string> before = contents();
        const Outcome outcome = run_program(program, arguments);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_TRUE(contains(outcome.err, "are the same file; nothing was written")) << outcome.err;
        EXPECT_EQ(contents(), before);
    }

    std::vector<std::string> contents() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
            if (entry.is_regular_file())
                all.push_back(entry.path().string() + "\n" + io::read_file(entry.path()));
        std::sort(all.begin(), all.end());
        return all;
    }

    Outcome with_input(const std::string& program, const Words& arguments,
                       const std::string& input) const {
        Surroundings surroundings;
        surroundings.standard_input = input;
        return run_program(program, arguments, surroundings);
    }

    TemporaryFolder folder_;
    std::string problem_ = write("problem.txt", joined(good_problem()));
    std::string solution_ = write("solution.txt", joined(good_solution()));
    const Words quick_ = {"--threads", "1", "--optimize", "0", "--quiet"};
};

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST_F(Files, AnOutputNeverDestroysAnInput) {
    fs::create_symlink("problem.txt", folder_ / "link");
    fs::create_hard_link(problem_, folder_ / "hard");
    fs::create_directory(folder_ / "sub");
    for (const std::string& name : {problem_, in("link"), in("hard"), in("sub/../problem.txt")})
        expect_refused("asv-solve", Words{problem_, name} + quick_);
    expect_refused("asv-solve", Words{in("link"), in("new"), "--trees", in("hard")} + quick_);
    expect_refused("asv-validate", {problem_, solution_, "--json", solution_});
    fs::create_symlink("solution.txt", folder_ / "picture.svg");
    expect_refused("asv-view", {problem_, solution_, "-o", in("picture.svg")});
    expect_refused("asv-bench", {problem_, "--csv", in("link")});
    expect_refused("asv-bench", {problem_, "--ompl-log", in("hard")});
}

TEST_F(Files, AnOutputNeverDestroysAnotherOutput) {
    fs::create_symlink("nowhere-yet", folder_ / "link");
    fs::create_directory(folder_ / "sub");
    expect_refused("asv-solve", Words{problem_, in("new"), "--stats", in("new")} + quick_);
    expect_refused("asv-solve", Words{problem_, in("new"), "--trees", in("sub/../new")} + quick_);
    expect_refused("asv-solve", Words{problem_, in("link"), "--stats", in("nowhere-yet")} + quick_);
    expect_refused("asv-view", {problem_, "-o", in("a.svg"), "-o", in("sub/../a.svg")});
    expect_refused("asv-bench", {problem_, "--csv", in("new"), "--json", in("new")});
    fs::create_symlink("p", folder_ / "p.json");
    expect_refused("asv-generate", {"clutter", "-n", "3", "--solvable", "-o", in("p")});
}

TEST_F(Files, AMapIsAnInputToo) {
    const std::string scenario = write("s.json", point_scenario);
    const std::string map = write("m.map", "00\n");
    expect_refused("asv-solve", Words{scenario, map} + quick_);
    expect_refused("asv-validate", {scenario, "--json", map});
    expect_refused("asv-bench", {scenario, "--csv", map});
    fs::create_symlink("m.map", folder_ / "m.svg");
    expect_refused("asv-view", {scenario, "-o", in("m.svg")});
}

TEST_F(Files, AGalleryLeavesItsCasesAlone) {
    fs::create_directory(folder_ / "out");
    const std::string page = write("out/page.html", joined(good_problem()));
    expect_refused("asv-view", {page, "--gallery", in("out")});
    const std::string index = write("index.txt", joined(good_problem()));
    EXPECT_EQ(run_program("asv-view", {index, "--gallery", in("both")}).exit_code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "both/index.html"));
    EXPECT_TRUE(fs::exists(folder_ / "both/index-2.html"));
}

TEST_F(Files, DevicesMayHaveManyRoles) {
    EXPECT_EQ(run_program("asv-solve", Words{problem_, "/dev/null", "--stats", "/dev/null",
                                             "--trees", "/dev/null"} +
                                           quick_)
                  .exit_code,
              0);
}

TEST_F(Files, ADashIsStandardInput) {
    EXPECT_EQ(with_input("asv-validate", {"-"}, problem_).exit_code, 0);
    EXPECT_EQ(with_input("asv-validate", {"-", solution_}, problem_).exit_code, 0);
    EXPECT_EQ(with_input("asv-validate", {problem_, "-"}, solution_).exit_code, 0);
    EXPECT_EQ(with_input("asv-solve", Words{"-", in("new")} + quick_, problem_).exit_code, 0);
    EXPECT_EQ(with_input("asv-view", {"-", "-o", in("a.svg")}, problem_).exit_code, 0);
    EXPECT_EQ(with_input("asv-bench", {"-", "--seeds", "1", "--optimize", "0"}, problem_).exit_code,
              0);
    const Outcome wrong = with_input("asv-validate", {"-"}, solution_);
    EXPECT_EQ(wrong.exit_code, 3);
    EXPECT_TRUE(wrong.err.starts_with("<stdin>:")) << wrong.err;
}

TEST_F(Files, ADashIsStandardOutput) {
    const Outcome path = run_program("asv-solve", Words{problem_, "-"} + quick_);
    EXPECT_EQ(path.exit_code, 0);
    EXPECT_TRUE(path.out.starts_with("1 "));
    const Outcome stats =
        run_program("asv-solve", Words{problem_, in("s"), "--stats", "-"} + quick_);
    EXPECT_TRUE(stats.out.starts_with("{"));
    const Outcome trees =
        run_program("asv-solve", Words{problem_, in("s"), "--trees", "-"} + quick_);
    EXPECT_TRUE(trees.out.starts_with("{"));
    const Outcome report = run_program("asv-validate", {problem_, "--json", "-"});
    EXPECT_TRUE(report.out.starts_with("{"));
    EXPECT_TRUE(report.err.ends_with("valid\n"));
    EXPECT_TRUE(contains(run_program("asv-view", {problem_, "-o", "-"}).out, "<svg"));
    EXPECT_TRUE(run_program("asv-view", {problem_, "-o", "-", "--format", "png"})
                    .out.starts_with("\x89PNG"));
    const Outcome csv =
        run_program("asv-bench", {problem_, "--seeds", "1", "--csv", "-", "--quiet"});
    EXPECT_TRUE(csv.out.starts_with("problem,planner")) << csv.out;
    EXPECT_FALSE(contains(csv.out, "###"));
    const Outcome drawn = run_program("asv-generate", {"clutter", "-n", "3", "-o", "-"});
    EXPECT_TRUE(drawn.out.starts_with("3\n"));
}

TEST_F(Files, ADashStandsForOneFileEachWay) {
    for (const auto& [program, arguments] : std::vector<std::pair<std::string, Words>>{
             {"asv-validate", {"-", "-"}},
             {"asv-solve", Words{problem_, "-", "--stats", "-"} + quick_},
             {"asv-view", {problem_, "-o", "-", "-o", "-"}},
             {"asv-bench", {problem_, "--csv", "-", "--json", "-"}},
             {"asv-bench", {problem_, "--table", "-", "--json", "-"}}}) {
        const Outcome outcome = run_program(program, arguments);
        EXPECT_EQ(outcome.exit_code, 2) << program;
        EXPECT_TRUE(contains(outcome.err, "cannot both be -")) << outcome.err;
    }
}

TEST_F(Files, WhatAFileHoldsReachesNoTerminalAsItIs) {
    const std::string scenario = write("s.json", point_scenario);
    const std::string name = write("\x1b[31m.txt", "\x1b[31m\n");
    write("m.map", "height 1\nwidth 2\n0\x1b[31m\n");
    for (const std::string& file : {scenario, name}) {
        for (const char* program : {"asv-solve", "asv-validate", "asv-view", "asv-bench"}) {
            Words words{file};
            if (program == std::string("asv-solve")) words.push_back(in("new"));
            if (program == std::string("asv-view")) words = words + Words{"-o", in("a.svg")};
            const Outcome outcome = run_program(program, words);
            EXPECT_EQ(outcome.exit_code, 3) << program;
            EXPECT_FALSE(contains(outcome.err, "\x1b")) << outcome.err;
        }
    }
}

TEST_F(Files, DeepBracketsAreAnErrorInEveryKindOfJson) {
    const std::string deep =
        write("deep.json", "{\"a\":" + std::string(66'000, '[') + std::string(66'000, ']') + "}");
    fs::create_directory(folder_ / "cases");
    write("cases/p.txt", joined(good_problem()));
    write("cases/p.trees.json", io::read_file(deep));
    for (const auto& [program, arguments] : std::vector<std::pair<std::string, Words>>{
             {"asv-solve", {deep, in("new")}},
             {"asv-validate", {deep}},
             {"asv-bench", {deep}},
             {"asv-view", {deep, "-o", in("a.svg")}},
             {"asv-view", {problem_, "--trees", deep, "-o", in("a.svg")}},
             {"asv-view", {problem_, "--stats", deep, "-o", in("a.svg")}},
             {"asv-view", {in("cases"), "--gallery", in("out")}}}) {
        const Outcome outcome = run_program(program, arguments);
        EXPECT_EQ(outcome.exit_code, 3) << program;
        EXPECT_TRUE(contains(outcome.err, "expected at most 64 brackets inside each other"))
            << outcome.err;
    }
}

}  // namespace
}  // namespace asv::test
