#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/benchmark/record/journal_text.hpp"
#include "io/benchmark/record/merge.hpp"
#include "io/benchmark/record/plan_facts.hpp"
#include "io/benchmark/record/runs_file.hpp"
#include "io/benchmark/runs_csv.hpp"
#include "io/benchmark/runs_json.hpp"
#include "io/benchmark/table/table.hpp"
#include "io/problem/problem_digest.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/files/benchmark_report_sample.hpp"
#include "tests/kit/files/text.hpp"

/// What is written of a benchmark, read again.

namespace asv::io {
namespace {

BenchmarkReport sample() {
    BenchmarkReport report = test::sample_report();
    for (core::BenchmarkProblem& problem : report.plan.problems)
        problem.digest = problem_digest(problem.problem);
    return report;
}

/// The runs of one planner alone, and that planner.
BenchmarkReport of_planner(std::size_t planner) {
    BenchmarkReport part = sample();
    std::erase_if(part.runs, [&](const auto& run) { return run.place.planner != planner; });
    for (core::BenchmarkRun& run : part.runs) run.place.planner = 0;
    part.plan.planners = {part.plan.planners[planner]};
    return part;
}

std::string journal_of(const BenchmarkReport& report) {
    std::string text = journal_head(report);
    for (const core::BenchmarkRun& run : report.runs) text += journal_run(report.plan, run);
    return text;
}

std::string refusal(std::vector<NamedReport> reports) {
    try {
        merged(std::move(reports));
    } catch (const MergeError& error) {
        return error.what();
    }
    return "merged";
}

TEST(ParseRuns, GivesBackWhatWasWritten) {
    BenchmarkReport report = sample();
    report.plan.problems[1].parameters = {{"height-factor", 1.3}, {"walls", 2}};
    const BenchmarkReport again = parse_runs(runs_json(report), "b.json");
    EXPECT_EQ(runs_json(again), runs_json(report));
    EXPECT_EQ(again.plan.problems[1].parameters, report.plan.problems[1].parameters);
    EXPECT_EQ(runs_csv(again), runs_csv(report));
    EXPECT_EQ(markdown_table(again), markdown_table(report));
}

TEST(ParseRuns, KnowsEveryStatus) {
    BenchmarkReport report = sample();
    for (std::size_t i = 0; i < core::all_run_statuses.size(); ++i)
        report.runs[i].status = core::all_run_statuses[i];
    EXPECT_EQ(runs_csv(parse_runs(runs_json(report), "b.json")), runs_csv(report));
}

TEST(ParseRuns, SaysWhereSomethingIsWrong) {
    const std::string text = runs_json(sample());
    const auto message = [&](const std::string& from, const std::string& to) {
        std::string spoilt = text;
        spoilt.replace(spoilt.find(from), from.size(), to);
        try {
            parse_runs(spoilt, "b.json");
        } catch (const ParseError& error) {
            return std::string(error.what());
        }
        return std::string("read");
    };
    EXPECT_TRUE(
        test::contains(message("runs 1", "runs 9"), "b.json:2:13: expected \"asv-bench runs 1\""));
    EXPECT_TRUE(test::contains(message("\"status\": \"solved\"", "\"status\": \"done\""),
                               "expected \"solved\" or \"timeout\""));
    EXPECT_TRUE(test::contains(message("\"planner\": \"rrt-connect\"", "\"planner\": \"magic\""),
                               "at planners[1].planner"));
    EXPECT_TRUE(
        test::contains(message("\"seed\": 4", "\"seed\": 3"), "a run that is not there already"));
    EXPECT_TRUE(test::contains(message("\"seed\": 4", "\"seed\": 5"), "one of the seeds"));
    EXPECT_TRUE(test::contains(message("\"obstacle_count\": 1", "\"obstacle_count\": 3000000"),
                               "expected an integer from 0 to 2000000"));
}

/// Wherever a process was killed, all lines before that are read.
TEST(ParseJournal, KeepsTheWholeLinesOfEveryBeginning) {
    const BenchmarkReport report = sample();
    const std::string text = journal_of(report);
    const std::size_t head = journal_head(report).size();
    std::size_t whole_runs = 0, whole = 0;
    for (std::size_t size = 0; size <= text.size(); ++size) {
        if (size > 0 && text[size - 1] == '\n') {
            whole = size;
            if (size > head) ++whole_runs;
        }
        // All around the ends of lines, and some of the others.
        constexpr std::size_t near = 2, some = 101;
        const bool near_end =
            text.substr(size < near ? 0 : size - near, 2 * near).find('\n') != std::string::npos;
        if (!near_end && size % some != 0) continue;
        const std::string_view beginning = std::string_view(text).substr(0, size);
        ASSERT_TRUE(is_journal(beginning));
        const auto journal = parse_journal(beginning, "j");
        ASSERT_EQ(journal.has_value(), size >= head) << size;
        if (!journal) continue;
        ASSERT_EQ(journal->size, whole);
        ASSERT_EQ(journal->report.runs.size(), whole_runs);
    }
    EXPECT_EQ(whole_runs, report.runs.size());
    EXPECT_EQ(runs_csv(parse_journal(text, "j")->report), runs_csv(report));
}

TEST(ParseJournal, DropsASpoiltLastLineAndRefusesOneBefore) {
    const BenchmarkReport report = sample();
    const std::string text = journal_of(report);
    const auto journal = parse_journal(text + std::string(7, '\0') + "\n", "j");
    ASSERT_TRUE(journal);
    EXPECT_EQ(journal->size, text.size());
    EXPECT_EQ(journal->report.runs.size(), 16U);
    std::string spoilt = text;
    spoilt[spoilt.find("{\"problem\":", journal_head(report).size())] = '!';
    try {
        parse_journal(spoilt, "j");
        FAIL() << "read";
    } catch (const ParseError& error) {
        EXPECT_EQ(error.line(), 2U) << error.what();
    }
    const std::string twice =
        text + journal_run(report.plan, report.runs[3]) + journal_session_end(report);
    EXPECT_THROW(parse_journal(twice, "j"), ParseError);
    EXPECT_FALSE(is_journal("3\n0.1 0.2\n"));
}

TEST(ParseJournal, SessionsAreTold) {
    BenchmarkReport report = sample();
    std::string text = journal_head(report);
    report.session.unit_before = report.session.unit_after = 0.5;
    report.session.total = 1;
    text += journal_session(report);
    report.session.unit_after = 1;
    text += journal_session_end(report);
    const BenchmarkSession session = parse_journal(text, "j")->report.session;
    ASSERT_EQ(session.parts.size(), 2U);
    EXPECT_EQ(session.total, 13.5);
    EXPECT_EQ(session.unit_before, 0.3125);
    EXPECT_EQ(session.unit_after, 0.6875);
}

TEST(DifferingPlans, NameWhatDiffers) {
    const BenchmarkReport here = sample();
    EXPECT_TRUE(differing_plans(here, here).empty());
    BenchmarkReport there = here;
    there.plan.time_limit = 5;
    there.plan.problems[0].digest = "0";
    there.plan.planners[1].settings[0].second = "off";
    const auto differing = differing_plans(here, there);
    ASSERT_EQ(differing.size(), 3U);
    EXPECT_EQ(differing[0], "time limit: 10 s here, 5 s there");
    EXPECT_TRUE(differing[1].starts_with("content of problem first: ")) << differing[1];
    EXPECT_EQ(differing[2],
              "planner swaps|1: rrt-connect swap-limiter=on here, "
              "rrt-connect swap-limiter=off there");
}

TEST(Merged, IsTheWhole) {
    const BenchmarkReport whole = merged({{"a", of_planner(0)}, {"b", of_planner(1)}});
    EXPECT_EQ(runs_csv(whole), runs_csv(sample()));
    EXPECT_EQ(whole.session.parts.size(), 2U);
    EXPECT_TRUE(whole.complete());
    EXPECT_TRUE(test::contains(markdown_table(whole), "1 thread. Runs of 2 sessions.\n"));
}

TEST(Merged, RefusesWhatDoesNotBelongTogether) {
    EXPECT_EQ(refusal({{"a", sample()}, {"b", of_planner(1)}}),
              "the run first forward, swaps|1, seed 3 is in a and again in b");
    BenchmarkReport other = of_planner(1);
    other.plan.problems[1].digest = "0";
    EXPECT_TRUE(test::contains(refusal({{"a", of_planner(0)}, {"b", other}}),
                               "another content of problem second, it"));
    other = of_planner(1);
    other.plan.optimize = 1;
    EXPECT_TRUE(test::contains(refusal({{"a", of_planner(0)}, {"b", other}}), "optimize: 0 s"));
    other = of_planner(1);
    other.plan.first_seed = 30;
    EXPECT_TRUE(test::contains(refusal({{"a", of_planner(0)}, {"b", other}}), "leave a gap"));
}

}  // namespace
}  // namespace asv::io
