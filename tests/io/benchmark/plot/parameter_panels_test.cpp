#include "io/benchmark/plot/parameter_panels.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "io/benchmark/plot/curve_plots.hpp"
#include "tests/kit/files/benchmark_report_sample.hpp"

namespace asv::io {
namespace {

/// The first problem at 0.1, the second at 0.3.
BenchmarkReport sweep_over_n() {
    BenchmarkReport report = test::sample_report();
    report.plan.problems[0].parameters = {{"height", 0.1}};
    report.plan.problems[1].parameters = {{"height", 0.3}};
    report.parameter = "height";
    return report;
}

TEST(ParameterPanels, HaveALineAndABandForEachPlanner) {
    const std::vector<CurvePanel> panels = parameter_panels(sweep_over_n());
    ASSERT_EQ(panels.size(), 2U);
    for (const CurvePanel& panel : panels) {
        EXPECT_EQ(panel.name, "height");
        ASSERT_EQ(panel.curves.size(), 2U);
        for (const Curve& curve : panel.curves) {
            ASSERT_EQ(curve.line.size(), 2U);
            ASSERT_EQ(curve.band.size(), 4U);
            EXPECT_EQ(curve.line[0].x, 0.1);
            EXPECT_EQ(curve.line[1].x, 0.3);
            EXPECT_GE(curve.band[0].y, curve.line[0].y);
            EXPECT_LE(curve.band[3].y, curve.line[0].y);
        }
    }
    // Seeds take 1/64 s and 3/64 s in both directions.
    EXPECT_EQ(panels[0].curves[0].line[0].y, 2.0 / 64);
    // One run of four is not solved.
    EXPECT_EQ(panels[1].curves[1].line[0].y, 0.75);
}

TEST(ParameterPanels, MediansBeyondTheLimitAreNotDrawn) {
    BenchmarkReport report = sweep_over_n();
    for (core::BenchmarkRun& run : report.runs) run.status = core::RunStatus::timeout;
    const std::vector<CurvePanel> panels = parameter_panels(report);
    EXPECT_TRUE(panels[0].curves[0].line.empty());
    EXPECT_EQ(panels[1].curves[0].line[1].y, 0);
    EXPECT_FALSE(draw_parameter(report, PictureFormat::svg, Theme::light).empty());
}

TEST(ParameterPanels, AreDrawnInEveryFormat) {
    EXPECT_TRUE(
        draw_parameter(sweep_over_n(), PictureFormat::png, Theme::dark).starts_with("\x89PNG"));
    const std::string svg = draw_parameter(sweep_over_n(), PictureFormat::svg, Theme::light);
    EXPECT_NE(svg.find("<title>Over height"), std::string::npos);
}

}  // namespace
}  // namespace asv::io
