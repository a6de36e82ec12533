#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

/// asv-solve --batch, as its users see it.

namespace asv::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string world = R"({"version": 1, "body": {"kind": "chain"},
 "obstacles": [[[0.45, 0], [0.5, 0.6]]],
 "start": {"at": [0.1, 0.2], "heading": 0, "turns": [10, 40, 40, 10]},
 "goal": {"shape": "hook", "at": [0.8, 0.2], "heading": 90}})";

class SolveBatch : public testing::Test {
  protected:
    std::string in(const std::string& name) const { return (folder_ / name).string(); }

    /// Of these queries about the world of that file.
    Outcome ask_about(const std::string& problem, const std::string& queries,
                      const Words& more = {}) {
        io::write_file(in("q.jsonl"), queries);
        Words words = {"--batch", in("q.jsonl"), problem, in("answers"), "--optimize", "0"};
        words.insert(words.end(), more.begin(), more.end());
        return run_program("asv-solve", words);
    }

    Outcome ask(const std::string& queries, const Words& more = {}) {
        io::write_file(in("w.json"), world);
        return ask_about(in("w.json"), queries, more);
    }

    std::string answer_text() const { return io::read_file(in("answers")); }

    std::vector<Json> answers() const {
        std::vector<Json> all;
        for (const std::string& line : lines_of(answer_text())) all.push_back(Json::parse(line));
        return all;
    }

    TemporaryFolder folder_;
};

TEST_F(SolveBatch, AnswersAreThoseOfSingleRuns) {
    std::filesystem::create_directory(in("paths"));
    const std::string goal = R"({"shape": "arc", "at": [0.85, 0.5], "heading": 90})";
    const Outcome outcome =
        ask("{}\n{\"id\": \"to the arc\", \"goal\": " + goal + "}\n", {"--solutions", in("paths")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "2 queries, 2 solved, in ")) << outcome.err;
    Json other = Json::parse(world);
    other["goal"] = Json::parse(goal);
    io::write_file(in("other.json"), other.dump());
    const std::vector<Json> all = answers();
    ASSERT_EQ(all.size(), 2U);
    for (const auto& [line, problem] : {std::pair(1, "w.json"), std::pair(2, "other.json")}) {
        const Outcome single = run_program("asv-solve", {in(problem), in("s"), "--optimize", "0",
                                                         "--threads", "1", "--stats", in("stats")});
        ASSERT_EQ(single.exit_code, 0);
        EXPECT_EQ(io::read_file(in("paths/" + std::to_string(line) + ".txt")),
                  io::read_file(in("s")));
        const Json stats = Json::parse(io::read_file(in("stats")));
        const Json& answer = all[static_cast<std::size_t>(line) - 1];
        EXPECT_EQ(answer["line"], line);
        EXPECT_EQ(answer["status"], "solved");
        EXPECT_EQ(answer["cost"], stats["cost"]);
        EXPECT_EQ(answer["primitive_steps"], stats["primitive_steps"]);
        EXPECT_EQ(answer["corners"].front()[0], (Json{0.1, 0.2}));
    }
    EXPECT_FALSE(all[0].contains("id"));
    EXPECT_EQ(all[1]["id"], "to the arc");
    EXPECT_EQ(all[1]["corners"].back()[0], (Json{0.85, 0.5}));
}

TEST_F(SolveBatch, AQueryThatIsWrongSpoilsNoOther) {
    const Outcome outcome =
        ask("{\"id\": 7, \"goal\": [[0.8, 0.2]]}\n"
            " \n"
            "{\"id\": 8, \"start\": {\"at\": [0.47, 0.2], \"heading\": 0, \"turns\": [10, 40, 40, "
            "10]}}\n"
            "{\"begin\": 3}\n"
            "no JSON\n"
            "{\"id\": true}\n"
            "[]\n"
            "{}");
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_TRUE(contains(outcome.err, "7 queries, 1 solved, 6 not understood or not valid"))
        << outcome.err;
    const std::string file = in("q.jsonl");
    const Words reasons = {
        file + ":1:19: expected an array of 6 points at goal, found [[0.8,0.2]]",
        file + ":3: start is not valid: broom 1 meets obstacle 1 by 0.03",
        file + ":4:11: expected no other members than id, start, goal at begin, found 3",
        file + ":5:2: expected JSON, found \"o\"",
        file + ":6:8: expected a text or a whole number at id, found true",
        file + ":7:1: expected an object at the document, found []"};
    const std::vector<Json> all = answers();
    ASSERT_EQ(all.size(), 7U);
    for (std::size_t i = 0; i < reasons.size(); ++i) {
        EXPECT_EQ(all[i]["status"], "error");
        EXPECT_EQ(all[i]["reason"], reasons[i]);
    }
    EXPECT_EQ(all[0]["id"], 7);
    EXPECT_EQ(all[1]["line"], 3);
    EXPECT_EQ(all[1]["id"], 8);
    EXPECT_EQ(all[6]["line"], 8);
    EXPECT_EQ(all[6]["status"], "solved");
}

TEST_F(SolveBatch, TellsWhichHaveNoPath) {
    const Outcome outcome = ask(
        R"({"goal": {"shape": "arc", "at": [0.85, 0.8], "heading": 90, "orientation": "clockwise"}})"
        "\n{}\n");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(contains(outcome.err, "2 queries, 1 solved, 1 without a path")) << outcome.err;
    const std::vector<Json> all = answers();
    EXPECT_EQ(all.at(0)["status"], "infeasible");
    EXPECT_TRUE(contains(all[0]["reason"], "turns left at the start and right at the goal"));
    EXPECT_EQ(all.at(1)["status"], "solved");
}

TEST_F(SolveBatch, HowManyAreAnsweredAtOnceChangesNothing) {
    std::string queries;
    for (int i = 0; i < 12; ++i)
        queries += R"({"goal": {"shape": "arc", "at": [0.85, 0.)" + std::to_string(40 + i) +
                   R"(], "heading": 90}})" + "\n";
    ask(queries, {"--threads", "1"});
    const std::string alone = answer_text();
    EXPECT_EQ(lines_of(alone).size(), 12U);
    ask(queries, {"--threads", "5"});
    EXPECT_EQ(answer_text(), alone);
}

TEST_F(SolveBatch, ArmsAndPointsAnswerInTheirOwnForm) {
    Outcome outcome = ask_about(testcase_file("bodies/arm-3-workshop.json"), "{}\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    Json corners = answers().at(0)["corners"];
    EXPECT_EQ(corners.front().size(), 3U);
    EXPECT_TRUE(corners.front()[0].is_number());
    // A corner is an end of another query.
    outcome = ask_about(testcase_file("bodies/arm-3-workshop.json"),
                        Json{{"start", corners.at(1)}}.dump());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err << answer_text();

    outcome = ask_about(testcase_file("bodies/point-town.json"), "{}\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    corners = answers().at(0)["corners"];
    outcome =
        ask_about(testcase_file("bodies/point-town.json"), Json{{"start", corners.at(1)}}.dump());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err << answer_text();
    EXPECT_EQ(answers().at(0)["corners"].front(), corners.at(1));
}

TEST_F(SolveBatch, ReadsAndWritesStreams) {
    io::write_file(in("w.json"), world);
    io::write_file(in("q.jsonl"), "{}\n{\"id\": 2}\n");
    Surroundings surroundings;
    surroundings.standard_input = in("q.jsonl");
    const Outcome outcome =
        run_program("asv-solve", {"--batch", "-", in("w.json"), "-", "--optimize", "0", "--quiet"},
                    surroundings);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(lines_of(outcome.out).size(), 2U);
}

TEST_F(SolveBatch, WhatCannotWorkIsToldBeforeAnythingIsTouched) {
    io::write_file(in("answers"), "precious");
    EXPECT_EQ(ask("{}", {"--stats", in("stats")}).exit_code, 2);
    EXPECT_EQ(ask("{}", {"--planner", "nobody"}).exit_code, 2);
    EXPECT_EQ(ask("{}", {"--solutions", in("nowhere")}).exit_code, 5);
    EXPECT_EQ(ask_about(in("nothing.txt"), "{}").exit_code, 3);
    EXPECT_EQ(ask("{}", {"--batch", in("nothing.jsonl")}).exit_code, 2);  // twice
    const Words missing = {"--batch", in("nothing.jsonl"), in("w.json"), in("answers")};
    EXPECT_EQ(run_program("asv-solve", missing).exit_code, 3);
    const Words folder = {"--batch", folder_.path().string(), in("w.json"), in("new")};
    EXPECT_EQ(run_program("asv-solve", folder).exit_code, 3);
    const Words same = {"--batch", in("q.jsonl"), in("w.json"), in("q.jsonl")};
    EXPECT_EQ(run_program("asv-solve", same).exit_code, 2);
    EXPECT_EQ(answer_text(), "precious");
}

TEST_F(SolveBatch, NoSolutionDestroysAnInput) {
    io::write_file(in("2.txt"), world);
    io::write_file(in("q.jsonl"), "{}\n{}\n");
    const Outcome outcome =
        run_program("asv-solve", {"--batch", in("q.jsonl"), in("2.txt"), in("answers"),
                                  "--optimize", "0", "--solutions", folder_.path().string()});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(contains(outcome.err, "are the same file")) << outcome.err;
    EXPECT_EQ(io::read_file(in("2.txt")), world);
    EXPECT_EQ(answers().size(), 1U);
}

TEST_F(SolveBatch, NoPartOfAnAnswerIsLeftWhereItCannotBeWritten) {
    io::write_file(in("w.json"), world);
    io::write_file(in("q.jsonl"), "{}\n{}\n{}\n{}\n{}\n{}\n");
    Surroundings surroundings;
    surroundings.largest_file = 5'000;
    const Outcome outcome = run_program(
        "asv-solve", {"--batch", in("q.jsonl"), in("w.json"), in("answers"), "--optimize", "0"},
        surroundings);
    EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
    const std::vector<Json> all = answers();
    EXPECT_GE(all.size(), 1U);
    EXPECT_LT(all.size(), 6U);
}

}  // namespace
}  // namespace asv::test
