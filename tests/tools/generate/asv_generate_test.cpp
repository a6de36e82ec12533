#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/validation/validate.hpp"
#include "io/problem/problem_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv {
namespace {

/// Runs asv-generate; files that it writes are in a folder of this test's own.
class GenerateProgram : public testing::Test {
  protected:
    /// The exit code. Arguments are separated by blanks; what follows -o is a name in the folder.
    int run(const std::string& arguments) {
        std::istringstream words(arguments);
        std::vector<std::string> list;
        for (std::string word; words >> word;) {
            const bool is_output = !list.empty() && list.back() == "-o";
            list.push_back(is_output ? path(word).string() : word);
        }
        outcome_ = test::run_program("asv-generate", list);
        return outcome_.exit_code;
    }
    const std::string& output() const { return outcome_.out; }
    const std::string& message() const { return outcome_.err; }
    std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    std::string text(const std::string& name) const { return io::read_file(path(name)); }
    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  private:
    test::TemporaryFolder folder_;
    test::Outcome outcome_;
};

TEST_F(GenerateProgram, EveryFamilyWritesAValidProblemWithItsDefaults) {
    for (const std::string family :
         {"corridor", "bend", "gauntlet", "rooms", "maze", "spiral", "crossing", "clutter"}) {
        SCOPED_TRACE(family);
        ASSERT_EQ(run(family + " -n 6 --seed 9 -o p.txt"), 0) << message();
        const io::ProblemFile file = io::read_problem(path("p.txt"));
        EXPECT_TRUE(file.warnings.empty());
        EXPECT_EQ(file.problem.asv_count(), 6u);
        for (const auto* end : {&file.problem.start, &file.problem.goal})
            EXPECT_TRUE(validate_state(file.problem, *end, {.tolerance = 1e-9}).valid());
        EXPECT_FALSE(exists("p.txt.json"));
        EXPECT_EQ(message(), "");
        EXPECT_EQ(output(), "");
    }
}

TEST_F(GenerateProgram, SameArgumentsGiveTheSameBytes) {
    ASSERT_EQ(run("rooms -n 7 --seed 5 --doors 1 --solvable -o a.txt"), 0) << message();
    const std::string problem = text("a.txt"), record = text("a.txt.json");
    ASSERT_EQ(run("-o a.txt --solvable --seed 5 -n 7 rooms --doors 1"), 0) << message();
    EXPECT_EQ(text("a.txt"), problem);
    EXPECT_EQ(text("a.txt.json"), record);
    ASSERT_EQ(run("rooms -n 7 --seed 6 --doors 1 -o a.txt"), 0) << message();
    EXPECT_NE(text("a.txt"), problem);
}

TEST_F(GenerateProgram, VerdictIsInTheSideFile) {
    ASSERT_EQ(run("corridor -n 5 --height-factor 1.05 --seed 3 --solvable -o p.txt"), 0);
    auto record = nlohmann::json::parse(text("p.txt.json"));
    EXPECT_EQ(record["verdict"], "solvable");
    EXPECT_EQ(record["family"], "corridor");
    EXPECT_EQ(record["seed"], 3);
    EXPECT_EQ(record["asv_count"], 5);
    EXPECT_EQ(record["obstacle_count"], 2);
    EXPECT_EQ(record["attempt"], 1);
    EXPECT_EQ(record["parameters"]["height-factor"], 1.05);
    EXPECT_EQ(record["parameters"]["orientation"], "random");
    EXPECT_NE(message().find("solvable"), std::string::npos);

    ASSERT_EQ(run("corridor -n 5 --height-factor 0.9 --solvable --attempts 2 --quiet -o q.txt"), 0);
    record = nlohmann::json::parse(text("q.txt.json"));
    EXPECT_EQ(record["verdict"], "infeasible");
    EXPECT_EQ(record["attempt"], 2);
    EXPECT_EQ(record["parameters"]["height-factor"], 0.9);
    EXPECT_TRUE(record["reason"].get<std::string>().starts_with(
        "no chain of 5 ASVs passes the corridor between obstacles 1 and 2: "));
    EXPECT_EQ(message(), "");

    // Shorter than the chain: that proof comes after the planner.
    ASSERT_EQ(run("corridor -n 5 --height-factor 0.3 --length 0.15 --solvable -o r.txt"), 0);
    record = nlohmann::json::parse(text("r.txt.json"));
    EXPECT_EQ(record["verdict"], "infeasible");
    EXPECT_TRUE(record["reason"].get<std::string>().starts_with(
        "no chain of 5 ASVs can have its middle between obstacles 1 and 2"));

    // Between what is proven and what is found.
    ASSERT_EQ(run("bend -n 3 --bends 1 --height-factor 1.3 --solvable -o s.txt"), 0);
    record = nlohmann::json::parse(text("s.txt.json"));
    EXPECT_EQ(record["verdict"], "unknown");
    EXPECT_NE(record["reason"], "");
}

TEST_F(GenerateProgram, ThePlannerIsAskedWhereTheSimpleCheckCannotTell) {
    ASSERT_EQ(run("bend -n 7 --seed 4 --solvable -o p.txt"), 0);
    const auto record = nlohmann::json::parse(text("p.txt.json"));
    EXPECT_EQ(record["verdict"], "solvable");
    EXPECT_EQ(record["reason"], "the planner finds a path, which the validator passes");
}

const std::string start_only = R"({"version": 1, "unit": "m",
 "body": {"kind": "chain", "broom_length": 20, "minimum_area_factor": 2.8, "asv_count": 5},
 "bounds": [[0, 0], [400, 400]], "obstacles": [[[180, 0], [200, 250]]],
 "start": {"shape": "arc", "at": [40, 80], "heading": 0}})";

TEST_F(GenerateProgram, DrawsTheGoalOfAScenarioThatHasAStartAlone) {
    const std::string from = path("start.json").string();
    io::write_file(from, start_only);
    ASSERT_EQ(run("--from " + from + " --seed 4 --solvable --quiet -o p.json"), 0) << message();
    EXPECT_EQ(message(), "");
    const io::ProblemFile file = io::read_problem(path("p.json"));
    EXPECT_EQ(file.unit, "m");
    EXPECT_EQ(file.problem.asv_count(), 5u);
    EXPECT_EQ(file.problem.obstacles.size(), 1u);
    EXPECT_EQ(file.problem.requirements.max_step, 0.4);
    EXPECT_EQ(test::run_program("asv-validate", {path("p.json").string()}).exit_code, 0);
    const auto record = nlohmann::json::parse(text("p.json.json"));
    EXPECT_EQ(record["family"], "from");
    EXPECT_EQ(record["verdict"], "solvable");
    EXPECT_FALSE(record["parameters"].contains("asvs"));
    EXPECT_EQ(record["parameters"]["clearance"], 0.001);
    const std::string once = text("p.json");
    ASSERT_EQ(run("-o p.json --seed 4 --from " + from), 0) << message();
    EXPECT_EQ(text("p.json"), once);
    ASSERT_EQ(run("-o p.json --seed 5 --from " + from), 0) << message();
    EXPECT_NE(text("p.json"), once);
}

TEST_F(GenerateProgram, SaysWhatIsWrongWithAStartOrWhatStandsBesideIt) {
    const std::string from = path("start.json").string();
    const auto expect = [&](const std::string& scenario, const std::string& words, int code,
                            const std::string& said) {
        io::write_file(from, scenario);
        EXPECT_EQ(run("--from " + from + " -o p.json" + words), code) << scenario;
        EXPECT_NE(message().find(said), std::string::npos) << message();
        EXPECT_FALSE(exists("p.json"));
    };
    expect(start_only, " maze", 2, "--from takes no family, but found maze");
    expect(start_only, " -n 5", 2, "--asvs has no place beside --from");
    expect(start_only, " --orientation cw", 2, "--orientation has no place beside --from");
    expect(start_only, " --walls 2", 2, "--from takes no --walls");
    const auto with = [](const std::string& part, const std::string& other) {
        std::string scenario = start_only;
        return scenario.replace(scenario.find(part), part.size(), other);
    };
    expect(with("\"start\"", "\"goal\": 7, \"start\""), "", 3, ":4:10: expected no other members");
    expect(with("[40, 80]", "[170, 80]"), "", 3, "start.json:4: start is not valid: broom ");
    expect(with("{\"kind\": \"chain\", \"broom_length\": 20, \"minimum_area_factor\": 2.8, "
                "\"asv_count\": 5}",
                "{\"kind\": \"chain\", \"broom_length\": 20}"),
           "", 3, ":2:10: expected the number of ASVs");
    io::write_file(from, "5\n");
    EXPECT_EQ(run("maze -n 5 --allow-maps-anywhere -o p.json"), 2);
}

TEST_F(GenerateProgram, WrongUsageIsNamedAndWritesNothing) {
    const auto expect_usage = [&](const std::string& arguments, const std::string& named) {
        EXPECT_EQ(run(arguments), 2) << arguments;
        EXPECT_NE(message().find(named), std::string::npos) << arguments << ": " << message();
        EXPECT_FALSE(exists("p.txt")) << arguments;
    };
    expect_usage("", "corridor, bend");
    expect_usage("corridor -o p.txt", "--asvs");
    expect_usage("corridor -n 7", "--output");
    expect_usage("-n 7 -o p.txt", "a family has to be named; there are corridor, bend");
    expect_usage("maz", "'maz' is no family; there are maze, ");
    expect_usage("-n 7 -o p.txt spirl", "'spirl' is no family; there are spiral, ");
    expect_usage("corridor -n 7 -o p.txt extra", "corridor takes no extra");
    expect_usage("corridor -n 2 -o p.txt", "asvs");
    expect_usage("corridor -n 201 -o p.txt", "asvs");
    expect_usage("corridor -n -7 -o p.txt", "--asvs");
    expect_usage("corridor -n seven -o p.txt", "--asvs");
    expect_usage("corridor -n 7 --seed -1 -o p.txt", "--seed");
    expect_usage("corridor -n 7 --height-factor nan -o p.txt", "height-factor");
    expect_usage("corridor -n 7 --height 0.9 -o p.txt", "height");
    expect_usage("corridor -n 7 --height 0.1 --height-factor 2 -o p.txt", "excludes");
    expect_usage("corridor -n 7 --walls 2 -o p.txt", "--walls");
    expect_usage("corridor -n 7 --orientation up -o p.txt", "--orientation");
    expect_usage("gauntlet -n 7 --walls -1 -o p.txt", "--walls");
    expect_usage("maze -n 7 --cells 40 -o p.txt", "cells");
    expect_usage("clutter -n 7 --obstacles 3000000 -o p.txt", "obstacles");
    expect_usage("corridor -n 70 -o p.txt", "leave more room");
    expect_usage("corridor -n 200 -o p.txt", "200 ASVs need a corridor 0.");
    expect_usage("maze -n 200 -o p.txt", "200 ASVs need a way ");
    expect_usage("corridor -n 7 --level 0x1p-1 -o p.txt", "0.1 to 0.9");
    expect_usage("clutter -n 7 --obstacles 18446744073709551616 -o p.txt", "0 to 1000000");
}

TEST_F(GenerateProgram, NumbersAreDecimal) {
    ASSERT_EQ(run("corridor -n 7 --seed 10 -o p.txt"), 0) << message();
    const std::string problem = text("p.txt");
    ASSERT_EQ(run("corridor -n 007 --seed 010 -o p.txt"), 0) << message();
    EXPECT_EQ(text("p.txt"), problem);
}

TEST_F(GenerateProgram, OutputThatCannotBeWrittenHasItsOwnCode) {
    EXPECT_EQ(run("corridor -n 7 -o missing/p.txt"), 5);
    EXPECT_NE(message().find("missing/p.txt"), std::string::npos);
    EXPECT_EQ(run("corridor -n 7 -o ."), 5);
}

TEST_F(GenerateProgram, HelpAndVersion) {
    EXPECT_EQ(run("--help"), 0);
    EXPECT_NE(output().find("Example"), std::string::npos);
    EXPECT_EQ(run("maze --help"), 0);
    EXPECT_NE(output().find("--way-factor"), std::string::npos);
    EXPECT_EQ(run("--version"), 0);
    EXPECT_NE(output().find("asv-generate "), std::string::npos);
}

}  // namespace
}  // namespace asv
