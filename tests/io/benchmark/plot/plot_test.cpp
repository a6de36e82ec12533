#include "io/benchmark/plot/plot.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/benchmark/plot/curve_plots.hpp"
#include "io/benchmark/plot/plot_axis.hpp"
#include "io/benchmark/plot/plot_data.hpp"
#include "tests/kit/files/benchmark_report_sample.hpp"

namespace asv::io {
namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
    std::vector<std::string> result;
    for (const Tick& tick : ticks) result.push_back(tick.label);
    return result;
}

TEST(TimeAxis, EndsAtRoundTimesAndHasTheirTicks) {
    const Axis axis = time_axis(0.00034, 13, 100, 500);
    EXPECT_NEAR(axis.low, 0.0002, 1e-12);
    EXPECT_NEAR(axis.high, 20, 1e-9);
    EXPECT_NEAR(axis.at(axis.low), 100, 1e-9);
    EXPECT_NEAR(axis.at(axis.high), 500, 1e-9);
    EXPECT_EQ(labels(time_ticks(axis)),
              (std::vector<std::string>{"1 ms", "10 ms", "100 ms", "1 s", "10 s"}));
    EXPECT_EQ(labels(time_ticks(time_axis(0.012, 0.19, 0, 1))),
              (std::vector<std::string>{"10 ms", "20 ms", "50 ms", "100 ms", "200 ms"}));
}

TEST(TimeAxis, OfOneTimeHasAnExtent) {
    for (const double time : {0.001, 0.002, 0.005, 0.0077}) {
        const Axis axis = time_axis(time, time, 0, 1);
        EXPECT_LT(axis.low, axis.high);
        EXPECT_LE(axis.low, time * (1 + 1e-9));
        EXPECT_GE(axis.high, time * (1 - 1e-9));
    }
}

TEST(CostAxis, HasRoundTicks) {
    EXPECT_EQ(labels(cost_ticks(cost_axis(1, 1.9, 0, 1))),
              (std::vector<std::string>{"1", "1.2", "1.4", "1.6", "1.8"}));
    EXPECT_EQ(labels(cost_ticks(cost_axis(1, 1.9, 0, 1), 3)),
              (std::vector<std::string>{"1", "1.5"}));
    const Axis single = cost_axis(3, 3, 0, 1);
    EXPECT_LT(single.low, single.high);
}

TEST(PlotPanels, HaveTheSolvedRunsOfEachPlannerAndDirection) {
    const auto panels = plot_panels(test::sample_report(), 2);
    ASSERT_EQ(panels.size(), 2U);
    EXPECT_EQ(panels[0].title, "first");
    ASSERT_EQ(panels[0].series.size(), 4U);
    const PlotSeries& unsolved = panels[0].series[3];
    EXPECT_EQ(unsolved.runs, 2U);
    EXPECT_EQ(unsolved.times, std::vector<double>{4.0 / 64});
    EXPECT_TRUE(panels[0].relative);
    EXPECT_EQ(unsolved.costs, std::vector<double>{1.25});
}

TEST(PlotPanels, TooManyProblemsAreOnePanel) {
    const auto panels = plot_panels(test::sample_report(), 1);
    ASSERT_EQ(panels.size(), 1U);
    EXPECT_EQ(panels[0].title, "All 2 problems");
    EXPECT_EQ(panels[0].series[0].runs, 4U);
}

TEST(PlotPanels, WithoutABoundCostsAreTheirOwn) {
    BenchmarkReport report = test::sample_report();
    report.runs[0].spent.cost_lower_bound = 0;
    const auto panels = plot_panels(report, 2);
    EXPECT_FALSE(panels[0].relative);
    EXPECT_EQ(panels[0].series[0].costs, (std::vector<double>{2.5, 2.5}));
    EXPECT_TRUE(panels[1].relative);
}

TEST(Plot, IsDrawnInEveryFormatAndTheme) {
    const BenchmarkReport report = test::sample_report();
    for (const Theme theme : {Theme::light, Theme::dark}) {
        EXPECT_TRUE(draw_benchmark(report, PictureFormat::png, theme).starts_with("\x89PNG"));
        EXPECT_TRUE(draw_benchmark(report, PictureFormat::pdf, theme).starts_with("%PDF"));
    }
    const std::string svg = draw_benchmark(report, PictureFormat::svg, Theme::light);
    EXPECT_NE(svg.find("<title>Benchmark"), std::string::npos);
}

TEST(CurvePlots, AreDrawnInEveryFormat) {
    BenchmarkReport report = test::sample_report();
    report.plan.jobs = 3;
    for (const auto draw : {draw_profiles, draw_costs_over_time}) {
        EXPECT_TRUE(
            draw(report, PictureFormat::png, Theme::dark, PlotLayout::wide).starts_with("\x89PNG"));
        EXPECT_TRUE(
            draw(report, PictureFormat::pdf, Theme::light, PlotLayout::wide).starts_with("%PDF"));
        const std::string svg = draw(report, PictureFormat::svg, Theme::light, PlotLayout::wide);
        for (const char* words : {"swaps|1", "their times are spoilt"})
            EXPECT_NE(svg.find(words), std::string::npos) << words;
    }
    const std::string svg = draw_profiles(report, PictureFormat::svg, Theme::light);
    EXPECT_NE(svg.find("<title>Performance profiles"), std::string::npos);
}

/// Its caption has what the heading says, but for what spoils the times.
TEST(PlotsInAColumn, AreNarrowAndWithoutAHeading) {
    BenchmarkReport report = test::sample_report();
    report.plan.jobs = 3;
    for (const auto draw : {draw_benchmark, draw_profiles, draw_costs_over_time}) {
        const std::string svg = draw(report, PictureFormat::svg, Theme::light, PlotLayout::column);
        EXPECT_NE(svg.find("width=\"360"), std::string::npos) << svg.substr(0, 300);
        for (const char* words : {">auto<", "their times are spoilt"})
            EXPECT_NE(svg.find(words), std::string::npos) << words;
        EXPECT_EQ(svg.find(">1 u = "), std::string::npos);
    }
}

TEST(PlotsInAColumn, SayWhichLinesAreReversed) {
    const std::string svg =
        draw_benchmark(test::sample_report(), PictureFormat::svg, Theme::light, PlotLayout::column);
    EXPECT_NE(svg.find(">reversed<"), std::string::npos);
}

TEST(PlotsInAColumn, SayHowManyOfTheirProblemsAreShown) {
    BenchmarkReport report = test::sample_report();
    for (std::size_t problem = 2; problem < 60; ++problem) {
        report.plan.problems.push_back(report.plan.problems[0]);
        report.runs.push_back(report.runs[0]);
        report.runs.back().place.problem = problem;
    }
    const std::string svg =
        draw_costs_over_time(report, PictureFormat::svg, Theme::light, PlotLayout::column);
    EXPECT_NE(svg.find(" of 62 problems)"), std::string::npos);
}

TEST(PlotsInAColumn, SayThatTheBenchmarkWasInterrupted) {
    BenchmarkReport report = test::sample_report();
    report.runs.pop_back();
    EXPECT_NE(draw_profiles(report, PictureFormat::svg, Theme::light, PlotLayout::column)
                  .find("Interrupted."),
              std::string::npos);
}

TEST(CurvePlots, PlannersWithoutASolutionAreNamed) {
    BenchmarkReport report = test::sample_report();
    for (core::BenchmarkRun& run : report.runs) run.status = core::RunStatus::timeout;
    for (const auto draw : {draw_profiles, draw_costs_over_time})
        EXPECT_NE(draw(report, PictureFormat::svg, Theme::light, PlotLayout::wide)
                      .find("auto (no curve)"),
                  std::string::npos);
}

TEST(CurvePlots, WhatDoesNotFitOnThePageIsSaid) {
    BenchmarkReport report = test::sample_report();
    report.plan.problems.resize(200, report.plan.problems[0]);
    for (std::size_t problem = 2; problem < 200; ++problem) {
        report.runs.push_back(report.runs[0]);
        report.runs.back().place.problem = problem;
    }
    const std::string svg = draw_costs_over_time(report, PictureFormat::svg, Theme::light);
    EXPECT_NE(svg.find(" of 202 problems and directions"), std::string::npos);
}

TEST(Plot, ShowsNamesOfAnyBytesAndThatTimesAreSpoilt) {
    BenchmarkReport report = test::sample_report();
    report.plan.problems[0].name = "q\xff\x01.txt";
    report.plan.planners[0].label = "\xed\xa0\x80";
    report.plan.jobs = 3;
    for (const PictureFormat format : {PictureFormat::svg, PictureFormat::png, PictureFormat::pdf})
        EXPECT_FALSE(draw_benchmark(report, format, Theme::light).empty());
}

TEST(Plot, IsDrawnWhereNothingIsSolvedAndWhereThereIsMuch) {
    BenchmarkReport report = test::sample_report();
    for (core::BenchmarkRun& run : report.runs) run.status = core::RunStatus::timeout;
    EXPECT_FALSE(draw_benchmark(report, PictureFormat::png, Theme::light).empty());
    report = test::sample_report();
    report.plan.problems.resize(200, report.plan.problems[0]);
    for (std::size_t problem = 2; problem < 200; ++problem) {
        report.runs.push_back(report.runs[0]);
        report.runs.back().place.problem = problem;
    }
    EXPECT_FALSE(draw_benchmark(report, PictureFormat::png, Theme::light).empty());
}

}  // namespace
}  // namespace asv::io
