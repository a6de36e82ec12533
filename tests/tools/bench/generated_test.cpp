#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/problem/problem_digest.hpp"
#include "io/problem/problem_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"
#include "tests/tools/bench/bench_runs.hpp"

/// Problems that are words of asv-generate instead of files.

namespace asv::test {
namespace {

using nlohmann::json;

const std::string corridor = "generate: corridor -n 4 --seed 3";

json content_of(const std::filesystem::path& file) {
    return json::parse(io::read_file(file));
}

/// A program that copies the problem it is given, and says that it has no path.
std::string copying(const std::filesystem::path& to) {
    return "copy: exec sh -c 'cp \"$1\" \"$2\"; exit 4' sh {problem} " + to.string() +
           " {solution}";
}

TEST(GeneratedProblem, IsTheOneOfTheFileAndItsCommandMakesIt) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    ASSERT_EQ(run_program("asv-generate", {"corridor", "-n", "4", "--seed", "3", "-o", in("c.txt")})
                  .exit_code,
              0);
    ASSERT_EQ(bench({" a  corridor : generate:  corridor   -n 4 --seed 3", in("c.txt")},
                    {"--json", in("b.json"), "--direction", "both"})
                  .exit_code,
              0);
    const json report = content_of(in("b.json"));
    EXPECT_EQ(report["problems"][0]["name"], "a corridor");
    EXPECT_EQ(report["problems"][0]["file"], corridor);
    EXPECT_EQ(report["problems"][0]["digest"], report["problems"][1]["digest"]);
    const json &runs = report["runs"], &made = runs[0], &read = runs[4];
    ASSERT_EQ(runs.size(), 8U);
    EXPECT_EQ(made["cost"], read["cost"]);
    EXPECT_EQ(made["state_checks"], read["state_checks"]);
    EXPECT_EQ(made["command"],
              "asv-generate corridor -n 4 --seed 3 -o - | asv-solve - solution.txt --planner auto "
              "--seed 1 --time-limit 10 --optimize 0 --threads 1");
    const std::string command = made["command"];
    const std::string in_folder = "cd '" + in(".") + "' && PATH=" + ASV_PROGRAM_DIR + ":$PATH && ";
    ASSERT_EQ(run_program("/bin/sh", {"-c", in_folder + command + " --stats s.json"}).exit_code, 0);
    EXPECT_EQ(content_of(in("s.json"))["cost"], made["cost"]);
}

TEST(GeneratedProblem, IsCalledByItsWordsWhereItHasNoLabel) {
    const Outcome outcome = bench({corridor, "generate: corridor -n 4 --seed 4"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* name : {"| corridor -n 4 --seed 3 | 2 of 2 |", "| corridor -n 4 --seed 4 | "})
        EXPECT_TRUE(contains(outcome.out, name)) << outcome.out;
}

TEST(GeneratedProblem, WrongWordsEndBeforeAnythingRuns) {
    const TemporaryFolder folder;
    const std::vector<std::pair<Words, std::string>> cases{
        {{"generate:"}, "asv-bench: generate: a family has to be named; there are corridor, bend"},
        {{"x: generate: "}, "asv-bench: generate: a family has to be named; there are corridor"},
        {{"generate: maz -n 4"}, "'maz' is no family; there are maze, "},
        {{"x: generate: corridor -n 2"}, "generate: corridor -n 2: asvs must be 1 or 3 to 200"},
        {{"generate: corridor -n 4 -o x.txt"}, "corridor takes no -o"},
        {{"generate: corridor -n 4 --seed -1"}, "--seed: '-1' is not a whole decimal number"},
        {{"generate: corridor -n 4 \x1b[31m"}, "control character"},
        {{corridor, "again: " + corridor}, "a problem is given twice: " + corridor},
        {{"x: " + corridor, "x: generate: maze -n 3"}, "two problems are called 'x'"}};
    for (const auto& [problems, message] : cases) {
        const Outcome outcome = bench(problems, {"--csv", (folder / "b.csv").string()});
        EXPECT_EQ(outcome.exit_code, 2) << problems[0];
        EXPECT_TRUE(contains(outcome.err, message)) << outcome.err;
    }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(GeneratedProblem, GoesToOtherProgramsAsAFile) {
    const TemporaryFolder folder;
    const auto copy = folder / "copy.txt";
    for (const char* direction : {"forward", "reversed"}) {
        const Outcome outcome =
            bench({corridor}, {"--direction", direction, "--planner", copying(copy), "--json",
                               (folder / "b.json").string()});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const json report = content_of(folder / "b.json");
        EXPECT_EQ(report["runs"][0]["status"], "infeasible");
        const core::Problem given = io::read_problem(copy).problem;
        EXPECT_EQ(io::problem_digest(given) == report["problems"][0]["digest"],
                  std::string(direction) == "forward");
        if (std::string(direction) == "reversed") continue;
        const std::string command = report["runs"][0]["command"];
        EXPECT_TRUE(
            command.starts_with("asv-generate corridor -n 4 --seed 3 -o problem.txt && sh -c "))
            << command;
        EXPECT_TRUE(contains(command, " sh problem.txt ")) << command;
    }
}

TEST(GeneratedProblem, IsKnownAgainInJournalsAndEarlierRuns) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    const Words problem{"c: " + corridor};
    ASSERT_EQ(bench(problem, {"--resume", in("j.jsonl"), "--json", in("a.json")}).exit_code, 0);
    ASSERT_EQ(bench(problem, {"--resume", in("j.jsonl"), "--json", in("b.json")}).exit_code, 0);
    EXPECT_EQ(io::read_file(in("a.json")), io::read_file(in("b.json")));
    const Outcome other =
        bench({"c: generate: corridor -n 4 --seed 5"}, {"--resume", in("j.jsonl")});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_TRUE(contains(other.err, "content of problem c: ")) << other.err;

    const Outcome more = run_program(
        "asv-bench",
        {"--from", in("j.jsonl"), "--planner", "rrt-connect", "--quiet", "--json", in("c.json")});
    ASSERT_EQ(more.exit_code, 0) << more.err;
    const json report = content_of(in("c.json"));
    EXPECT_EQ(report["problems"][0]["name"], "c");
    ASSERT_EQ(report["runs"].size(), 4U);
    EXPECT_EQ(report["runs"][2]["planner"], "rrt-connect");
    EXPECT_EQ(report["runs"][2]["status"], "solved");
}

TEST(GeneratedProblem, HasItsParametersWithin) {
    const TemporaryFolder folder;
    const auto in = [&](const char* name) { return (folder / name).string(); };
    const Words problems{"generate: corridor -n 3 --height-factor 2",
                         "generate: corridor -n 3 --height-factor 3"};
    ASSERT_EQ(bench(problems, {"--parameter", "height-factor", "--parameter-plot", in("h.svg"),
                               "--json", in("b.json")})
                  .exit_code,
              0);
    EXPECT_TRUE(contains(io::read_file(in("h.svg")), "Over height-factor"));
    EXPECT_EQ(content_of(in("b.json"))["problems"][1]["parameters"]["height-factor"], 3);
    EXPECT_EQ(bench(problems, {"--parameter", "n"}).exit_code, 0);
    const Outcome none = bench(problems, {"--parameter", "walls"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_TRUE(
        contains(none.err, "--parameter walls: corridor -n 3 --height-factor 2 has no such"))
        << none.err;
}

}  // namespace
}  // namespace asv::test
