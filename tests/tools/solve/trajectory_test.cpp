#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

/// What users of --trajectory see, in asv-solve and asv-validate. Files are read here by other code
/// than the programs', and limits are checked by it.

namespace asv::test {
namespace {

using Numbers = std::vector<double>;
using Words = std::vector<std::string>;

/// Times, and of each time x and y of every vehicle.
struct Samples {
    Numbers times;
    std::vector<Numbers> places;
};

Samples samples_of_csv(const std::string& text) {
    constexpr std::size_t columns = 4;
    Samples samples;
    Words lines = lines_of(text);
    lines.erase(lines.begin());
    for (const std::string& line : lines) {
        std::istringstream cells(line);
        Numbers row;
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
        samples.times.push_back(row[0]);
        Numbers places;
        for (std::size_t i = 1; i < row.size(); i += columns)
            places.insert(places.end(), {row[i], row[i + 1]});
        samples.places.push_back(places);
    }
    return samples;
}

Samples samples_of_json(const std::string& text) {
    Samples samples;
    const auto file = nlohmann::json::parse(text);
    for (const auto& sample : file["samples"]) {
        samples.times.push_back(sample["time"]);
        Numbers places;
        for (const auto& place : sample["positions"])
            places.insert(places.end(), {place[0].get<double>(), place[1].get<double>()});
        samples.places.push_back(places);
    }
    return samples;
}

/// The greatest speed or acceleration of a vehicle.
struct Greatest {
    double speed = 0, acceleration = 0;
};

Greatest greatest_of(const Samples& samples, std::size_t vehicle) {
    Greatest greatest;
    double vx = 0, vy = 0, before = 0;
    for (std::size_t k = 1; k <= samples.times.size(); ++k) {
        double next_vx = 0, next_vy = 0, time = 0;
        if (k < samples.times.size()) {
            time = samples.times[k] - samples.times[k - 1];
            const Numbers &from = samples.places[k - 1], &to = samples.places[k];
            next_vx = (to[2 * vehicle] - from[2 * vehicle]) / time;
            next_vy = (to[2 * vehicle + 1] - from[2 * vehicle + 1]) / time;
        }
        greatest.speed = std::max(greatest.speed, std::hypot(next_vx, next_vy));
        greatest.acceleration = std::max(
            greatest.acceleration, 2 * std::hypot(next_vx - vx, next_vy - vy) / (before + time));
        vx = next_vx;
        vy = next_vy;
        before = time;
    }
    return greatest;
}

class Trajectories : public testing::Test {
  protected:
    std::string in(const std::string& name) const { return folder_ / name; }

    Outcome solve(const std::string& problem, const Words& more) const {
        Words arguments{problem, in("s"), "--threads", "1", "--optimize", "0"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program("asv-solve", arguments);
    }

    /// With a trajectory of the problem in that file.
    Outcome validate(const std::string& problem, const std::string& trajectory,
                     const Words& more) const {
        Words arguments{problem, in("s"), "--trajectory", in(trajectory)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program("asv-validate", arguments);
    }

    TemporaryFolder folder_;
    const std::string chain_ = testcase_file("7ASV.txt");
    const Words limits_{"--speed", "0.05", "--acceleration", "0.02"};
};

Words both(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST_F(Trajectories, KeepAllLimitsWhenTheyAreReadBack) {
    // ASV 3 is slow, ASV 5 is heavy.
    const Numbers speeds{0.05, 0.05, 0.02, 0.05, 0.05, 0.05, 0.05};
    const Numbers accelerations{0.02, 0.02, 0.02, 0.02, 0.004, 0.02, 0.02};
    const Words limits{"--speed", "0.05,0.05,0.02,0.05,0.05,0.05,0.05", "--acceleration",
                       "0.02,0.02,0.02,0.02,0.004,0.02,0.02"};
    for (const std::string name : {"t.csv", "t.json"}) {
        SCOPED_TRACE(name);
        ASSERT_EQ(solve(chain_, both({"--trajectory", in(name)}, limits)).exit_code, 0);
        const std::string text = io::read_file(in(name));
        const Samples samples = name == "t.csv" ? samples_of_csv(text) : samples_of_json(text);
        ASSERT_GT(samples.times.size(), 1000U);
        double nearest = 0;
        for (std::size_t i = 0; i < speeds.size(); ++i) {
            const Greatest greatest = greatest_of(samples, i);
            EXPECT_LE(greatest.speed, speeds[i] * (1 + 1e-9)) << i;
            EXPECT_LE(greatest.acceleration, accelerations[i] * (1 + 1e-9)) << i;
            nearest = std::max(
                {nearest, greatest.speed / speeds[i], greatest.acceleration / accelerations[i]});
        }
        EXPECT_GT(nearest, 0.999) << "some limit is used";
        const Outcome verdict = validate(chain_, name, limits);
        EXPECT_EQ(verdict.exit_code, 0) << verdict.out;
    }
}

TEST_F(Trajectories, OfAllBodiesAreValid) {
    for (const char* name : {"bodies/arm-3-workshop.json", "bodies/point-town.json"}) {
        const std::string problem = testcase_file(name);
        const Words limits{"--speed", "2", "--acceleration", "0.5"};
        ASSERT_EQ(solve(problem, both({"--trajectory", in("t.csv")}, limits)).exit_code, 0);
        const Outcome verdict = validate(problem, "t.csv", limits);
        EXPECT_EQ(verdict.exit_code, 0) << verdict.out;
        EXPECT_EQ(count(verdict.out, "trajectory\n"), 1U) << verdict.out;
    }
}

TEST_F(Trajectories, TakeHardlyLongerThanFullSpeedOnALongStraightRun) {
    io::write_file(in("p.json"), R"({"version": 1, "body": {"kind": "point"}, "start": [0, 0],
        "goal": [1000, 0], "bounds": null, "step": 0.5,
        "limits": {"speed": 1.5, "acceleration": 0.3}})");
    const Outcome outcome = solve(in("p.json"), {"--trajectory", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Numbers times = samples_of_csv(outcome.out).times;
    const double bound = 1000 / 1.5;
    EXPECT_GE(times.back(), bound);
    EXPECT_LE(times.back(), 1.01 * bound);
    EXPECT_EQ(count(outcome.err, "trajectory: 67"), 1U) << outcome.err;
}

TEST_F(Trajectories, OptionsStandAboveTheLimitsOfAScenario) {
    io::write_file(in("p.json"), R"({"version": 1, "body": {"kind": "point"}, "start": [0, 0],
        "goal": [1, 0], "bounds": null, "step": 0.01, "limits": {"speed": 0.1}})");
    const Outcome missing = solve(in("p.json"), {"--trajectory", in("t.csv")});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_TRUE(contains(missing.err, "--acceleration")) << missing.err;
    EXPECT_TRUE(contains(missing.err, R"("limits": {"acceleration": ...})")) << missing.err;
    EXPECT_EQ(folder_.entries(), 1) << "nothing was written";
    const Words acceleration{"--acceleration", "1"};
    ASSERT_EQ(solve(in("p.json"), both({"--trajectory", in("t.csv")}, acceleration)).exit_code, 0);
    EXPECT_NEAR(greatest_of(samples_of_csv(io::read_file(in("t.csv"))), 0).speed, 0.1, 1e-6);
    const Words faster = both({"--speed", "0.2"}, acceleration);
    ASSERT_EQ(solve(in("p.json"), both({"--trajectory", in("f.csv")}, faster)).exit_code, 0);
    EXPECT_NEAR(greatest_of(samples_of_csv(io::read_file(in("f.csv"))), 0).speed, 0.2, 1e-6);
    EXPECT_EQ(validate(in("p.json"), "t.csv", acceleration).exit_code, 0);
    EXPECT_EQ(validate(in("p.json"), "f.csv", acceleration).exit_code, 1);
    EXPECT_EQ(validate(in("p.json"), "f.csv", faster).exit_code, 0);
}

TEST_F(Trajectories, AreRefusedWithTheWorstOffender) {
    ASSERT_EQ(solve(chain_, both({"--trajectory", in("t.csv")}, limits_)).exit_code, 0);
    const Outcome slow = validate(chain_, "t.csv", {"--speed", "0.025", "--acceleration", "0.02"});
    EXPECT_EQ(slow.exit_code, 1);
    EXPECT_TRUE(contains(slow.out, " is too fast by 0.025 (state ")) << slow.out;
    EXPECT_EQ(count(slow.out, "FAILED"), 1U) << slow.out;
    const Outcome weak = validate(chain_, "t.csv", {"--speed", "0.05", "--acceleration", "0.01"});
    EXPECT_EQ(weak.exit_code, 1);
    EXPECT_TRUE(contains(weak.out, " changes its velocity too fast by 0.01 (state ")) << weak.out;
    // Where the sample of state 500 is left out.
    Words lines = lines_of(io::read_file(in("t.csv")));
    lines.erase(lines.begin() + 501);
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    io::write_file(in("t.csv"), text);
    const Outcome cut = validate(chain_, "t.csv", {"--speed", "9", "--acceleration", "9"});
    EXPECT_EQ(cut.exit_code, 1);
    EXPECT_TRUE(contains(cut.out, "same path             FAILED  1 of 501 states: ASV "))
        << cut.out;
    EXPECT_TRUE(contains(cut.out, "(state 500, line 502)")) << cut.out;
}

TEST_F(Trajectories, OfAStartThatIsTheGoalHaveOneSample) {
    io::write_file(in("p.json"), R"({"version": 1, "body": {"kind": "point"}, "start": [1, 0],
        "goal": [1, 0], "bounds": null, "limits": {"speed": 1, "acceleration": 1}})");
    for (const std::string name : {"t.csv", "t.json", "t.yaml"})
        ASSERT_EQ(solve(in("p.json"), {"--trajectory", in(name)}).exit_code, 0) << name;
    EXPECT_EQ(io::read_file(in("t.csv")), "time,x1,y1,heading1,speed1\n0,1,0,0,0\n");
    EXPECT_EQ(validate(in("p.json"), "t.csv", {}).exit_code, 0);
    EXPECT_EQ(validate(in("p.json"), "t.json", {}).exit_code, 0);
}

TEST_F(Trajectories, AreTheSameForTheSameSolution) {
    for (const std::string name : {"a.csv", "b.csv"})
        ASSERT_EQ(solve(chain_, both({"--trajectory", in(name)}, limits_)).exit_code, 0);
    EXPECT_EQ(io::read_file(in("a.csv")), io::read_file(in("b.csv")));
}

TEST_F(Trajectories, WrongUsageIsToldBeforeAnythingIsWritten) {
    const std::string out = in("t.csv");
    const std::vector<std::pair<Words, std::string>> wrong{
        {{"--trajectory", in("t.txt"), "--speed", "1", "--acceleration", "1"}, ".csv, .json or"},
        {{"--trajectory", out, "--acceleration", "1"}, R"(by --speed, or by "limits")"},
        {{"--trajectory", out, "--speed", "1,2", "--acceleration", "1"},
         "--speed has 2 numbers; it takes one for all vehicles or one for each of 7"},
        {{"--trajectory", out, "--speed", "0", "--acceleration", "1"}, "from 1e-12 to 1e+12"},
        {{"--speed", "1"}, "--trajectory"},
        {{"--trajectory", out, "--stats", out, "--speed", "1", "--acceleration", "1"},
         "are the same file"}};
    for (const auto& [options, message] : wrong) {
        const Outcome outcome = solve(chain_, options);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_TRUE(contains(outcome.err, message)) << outcome.err;
        EXPECT_EQ(folder_.entries(), 0);
    }
    const Outcome alone = run_program("asv-validate", {chain_, "--trajectory", out});
    EXPECT_EQ(alone.exit_code, 2);
    EXPECT_TRUE(contains(alone.err, "--trajectory needs a SOLUTION")) << alone.err;
}

TEST_F(Trajectories, AreNotWrittenWhereNoPathIs) {
    const std::string problem = testcase_file("infeasible/opposite-orientation.txt");
    ASSERT_TRUE(std::filesystem::exists(problem));
    EXPECT_EQ(solve(problem, both({"--trajectory", in("t.csv")}, limits_)).exit_code, 4);
    EXPECT_EQ(folder_.entries(), 0);
}

TEST_F(Trajectories, AsJsonOfTheValidatorHaveAPartOfTheirOwn) {
    ASSERT_EQ(solve(chain_, both({"--trajectory", in("t.json")}, limits_)).exit_code, 0);
    const Outcome outcome = validate(chain_, "t.json", both(limits_, {"--json", "-"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto part = nlohmann::json::parse(outcome.out)["parts"].at(1);
    EXPECT_EQ(part["name"], "trajectory");
    EXPECT_EQ(part["valid"], true);
    ASSERT_EQ(part["checks"].size(), 4U);
    EXPECT_EQ(part["checks"][3]["check"], "acceleration");
    EXPECT_GE(part["checks"][3]["worst"]["line"], 2);
}

}  // namespace
}  // namespace asv::test
