#include "io/benchmark/table/table.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "io/benchmark/report.hpp"
#include "tests/kit/files/benchmark_report_sample.hpp"
#include "tests/kit/files/text.hpp"

namespace asv::io {
namespace {

TEST(Table, HasASectionForEachProblemAndDirection) {
    const std::string table = markdown_table(test::sample_report());
    for (const char* heading : {"### first, forward\n", "### first, reversed\n",
                                "### second, it, forward\n", "### second, it, reversed\n"})
        EXPECT_TRUE(test::contains(table, heading)) << table;
    EXPECT_TRUE(test::contains(table, "3 ASVs, 1 obstacle; no path costs less than 2.000.\n"))
        << table;
}

TEST(Table, TellsTheSessionAndItsUnit) {
    const std::string table = markdown_table(test::sample_report());
    EXPECT_TRUE(
        table.starts_with("asv-bench 1.2.3, 1970-01-01 00:00:00 UTC, host (CPU, 2 "
                          "processors). Seeds 3 to 4, time limit 10 s, optimize 0 s, 1 "
                          "thread.\n"))
        << table;
    EXPECT_TRUE(
        test::contains(table,
                       "1 u is the time of 10^6 scalar state checks of 7 ASVs in this session: "
                       "250.0 ms (125.0 before the runs, 375.0 after them)"))
        << table;
}

TEST(Table, RowsHoldTheFiguresOfHand) {
    const std::string table = markdown_table(test::sample_report());
    // 1/64 s and 3/64 s; the unit is 250 ms. Of two solved runs two are with a chance of p^2, which
    // is 2.5 % for p = 0.1581.
    EXPECT_TRUE(
        test::contains(table,
                       "| auto | 2 of 2 | 100.0 (15.81, 100.0) | 31.25 (15.62, 46.88) | 43.75 | "
                       "31.25 | 0.1250 | 400 | 3.000 | 2.500 (2.500, 2.500) | 1.250 |\n"))
        << table;
    // 4/64 s and more than 10 s: the median is more than their mean, PAR-2 that of 4/64 s and 20 s.
    EXPECT_TRUE(
        test::contains(table,
                       "| swaps\\|1 | 1 of 2 | 50.00 (1.258, 98.74) | >5031 (62.50, >10000) | "
                       ">9006 | 10031 | >20.12 | 400 | 3.000 | 2.500 (2.500, 2.500) | 1.250 |\n"))
        << table;
}

TEST(Table, TellsOfAllProblemsTogether) {
    BenchmarkReport report = test::sample_report();
    const std::string table = markdown_table(report);
    // 1/64, 1/64, 3/64 and 3/64 s; neither checks nor costs.
    EXPECT_TRUE(test::contains(table, "### All 2 problems, forward\n")) << table;
    EXPECT_TRUE(test::contains(
        table,
        "| auto | 4 of 4 | 100.0 (39.76, 100.0) | 31.25 (15.62, 46.88) | 46.88 | 31.25 | "
        "0.1250 | 1.250 |\n"))
        << table;
    EXPECT_FALSE(test::contains(table, "invalid"));
    EXPECT_TRUE(test::contains(markdown_table(report, columns_named("ratio,cost,solved")),
                               "| auto | 1.250 | 4 of 4 |\n"));
    EXPECT_TRUE(
        test::contains(markdown_table(report, columns_named("cost")), "| auto | 4 of 4 |\n"));
}

TEST(Table, TellsOfInvalidPathsWhereThereAreAny) {
    BenchmarkReport report = test::sample_report();
    for (core::BenchmarkRun& run : report.runs)
        if (run.place == core::RunPlace{1, 0, core::Direction::forward, 4})
            run.status = core::RunStatus::invalid;
    const std::string table = markdown_table(report, columns_named("solved"));
    EXPECT_TRUE(test::contains(table, "| auto | 3 of 4 | 1 of 4 |\n")) << table;
}

TEST(Table, OfOneProblemIsNoOverview) {
    BenchmarkReport report = test::sample_report();
    report.plan.problems.pop_back();
    std::erase_if(report.runs, [](const auto& run) { return run.place.problem == 1; });
    EXPECT_FALSE(test::contains(markdown_table(report), "problems, forward"));
}

TEST(Table, NamesBeginNoColumnsLinksOrLines) {
    BenchmarkReport report = test::sample_report();
    report.plan.planners[1].label = "a\\|b\n![x](y) <i> `c` \x1b[31m";
    const std::string table = markdown_table(report);
    EXPECT_TRUE(test::contains(
        table, "| a\\\\\\|b\\\\x0A!\\[x\\](y) &lt;i> \\`c\\` \\\\x1B\\[31m | 1 of 2 |"))
        << table;
}

TEST(Table, ComparesEveryTwoPlannersAtTheEnd) {
    const std::string table = markdown_table(test::sample_report());
    // 8 pairs, in all of which the first is faster: p = 2 / 2^8, and twice that for two rows.
    const std::string rows =
        "| of | first | second | pairs | ratio (95 % CI) | A12 | better on | p | p (Holm) |\n"
        "|---|---|---|---:|---:|---:|---:|---:|---:|\n"
        "| time | auto | swaps\\|1 | 8 | 0.2500 (0.2500, 0.2500) | 1.000 | 4 : 0 | 0.007812 | "
        "0.01562 |\n"
        "| cost | auto | swaps\\|1 | 7 | 1.000 (1.000, 1.000) | 0.5000 | 0 : 0 | 1.000 | 1.000 |\n";
    EXPECT_TRUE(test::contains(table, "### Planners compared\n")) << table;
    EXPECT_TRUE(test::contains(table, rows)) << table;
    EXPECT_GT(table.find("### Planners compared"), table.find("### second, it, reversed"));
}

TEST(Table, SmallPAreBounds) {
    BenchmarkReport report = test::sample_report();
    report.plan.seeds = 20;
    report.runs.clear();
    for (const core::RunPlace& place : core::places(report.plan)) {
        report.runs.push_back(test::sample_report().runs[place.planner * 2]);
        report.runs.back().place = place;
    }
    EXPECT_TRUE(test::contains(markdown_table(report), "| 4 : 0 | <0.0001 | <0.0001 |\n"));
}

TEST(Table, HasTheColumnsThatAreChosen) {
    const std::string table =
        markdown_table(test::sample_report(), columns_named("par2-ms,solved-std-ms,nodes"));
    EXPECT_TRUE(test::contains(table,
                               "| planner | PAR-2 ms | std ms, solved only | nodes |\n"
                               "|---|---:|---:|---:|\n"
                               "| auto | 31.25 | 22.10 | 30 |\n"))
        << table;
    // The deviation of a single run; nothing of the one that is not solved.
    EXPECT_TRUE(test::contains(table, "| swaps\\|1 | 10031 | 0 | 30 |\n")) << table;
}

TEST(Table, HasMeansOfWorkBesideItsMedians) {
    BenchmarkReport report = test::sample_report();
    report.runs[0].spent.tree_nodes[0] = 1010;
    report.runs[0].spent.state_checks = 1401;
    const std::string table =
        markdown_table(report, columns_named("nodes,mean-nodes,checks,mean-checks"));
    EXPECT_TRUE(test::contains(table,
                               "| planner | nodes | mean nodes | state checks | mean state checks "
                               "|\n|---|---:|---:|---:|---:|\n"
                               "| auto | 530 | 530 | 900 | 901 |\n"))
        << table;
}

TEST(Columns, AnUnknownOneIsToldWithThoseThereAre) {
    for (const char* keys : {"solved,magic", "", "solved,", "solved cost"}) try {
            columns_named(keys);
            ADD_FAILURE() << keys;
        } catch (const std::invalid_argument& error) {
            EXPECT_TRUE(test::contains(error.what(), "there are solved, rate, ")) << error.what();
        }
}

TEST(Table, ListsTheSeedsThatWereNotSolved) {
    const std::string table = markdown_table(test::sample_report());
    EXPECT_TRUE(
        table.ends_with("\nNot solved:\n\n- first reversed, swaps\\|1: timeout (no path "
                        "found: deadline), seed 4\n"))
        << table;
}

TEST(Table, NoneSolvedHasBoundsOfTimesAndNoCosts) {
    BenchmarkReport report = test::sample_report();
    for (core::BenchmarkRun& run : report.runs) run.status = core::RunStatus::timeout;
    EXPECT_TRUE(
        test::contains(markdown_table(report),
                       "| auto | 0 of 2 | 0 (0, 84.19) | >10000 (>10000, >10000) | >10000 | 20000 "
                       "| >40.00 | - | - | - | - |\n"))
        << markdown_table(report);
}

TEST(Table, OnePlannerHasProblemsAsRows) {
    BenchmarkReport report = test::sample_report();
    report.plan.planners.resize(1);
    std::erase_if(report.runs, [](const core::BenchmarkRun& run) { return run.place.planner > 0; });
    const std::string table = markdown_table(report);
    EXPECT_TRUE(test::contains(table, "### auto, forward\n\n| problem | solved |")) << table;
    EXPECT_TRUE(test::contains(table, "\n| first | 2 of 2 |")) << table;
    EXPECT_TRUE(test::contains(table, "\n| second, it | 2 of 2 |")) << table;
    EXPECT_FALSE(test::contains(table, "Not solved"));
    EXPECT_FALSE(test::contains(table, "Planners compared"));
}

TEST(Table, SaysWhatSpoilsIt) {
    BenchmarkReport report = test::sample_report();
    report.plan.jobs = 3;
    report.runs.pop_back();
    const std::string table = markdown_table(report);
    EXPECT_TRUE(test::contains(table, "3 runs side by side: their times are spoilt.")) << table;
    EXPECT_TRUE(test::contains(table, "Interrupted: 15 of 16 runs.")) << table;
}

TEST(ShortNumber, HasFourDigitsAndNoExponent) {
    const std::vector<std::pair<double, std::string>> expected{
        {0, "0"},           {1234567, "1234567"},      {9999.7, "10000"},  {999.96, "1000"},
        {123.456, "123.5"}, {99.996, "100.0"},         {9.99961, "10.00"}, {1.5, "1.500"},
        {0.5, "0.5000"},    {0.00012346, "0.0001235"}, {1e-9, "0"},        {-2.5, "-2.500"}};
    for (const auto& [value, text] : expected) EXPECT_EQ(short_number(value), text);
}

TEST(SolveCommand, RepeatsARun) {
    const BenchmarkReport report = test::sample_report();
    EXPECT_EQ(solve_command(report.plan, {0, 0, core::Direction::forward, 3}),
              "asv-solve cases/first.txt solution.txt --planner auto --seed 3 --time-limit 10 "
              "--optimize 0 --threads 1");
    EXPECT_EQ(solve_command(report.plan, {1, 1, core::Direction::reversed, 4}),
              "asv-solve 'cases/second, it.txt' solution.txt --planner rrt-connect --set "
              "swap-limiter=on --seed 4 --time-limit 10 --optimize 0 --threads 1 --reverse");
}

}  // namespace
}  // namespace asv::io
