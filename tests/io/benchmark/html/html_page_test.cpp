#include "io/benchmark/html/html_page.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/benchmark/html/chart_json.hpp"
#include "io/benchmark/html/table_markup.hpp"
#include "tests/kit/files/benchmark_report_sample.hpp"

/// What the page looks like is for tests/browser.

namespace asv::io {
namespace {

using nlohmann::json;

TEST(ChartJson, HasAllRunsTogetherAndEachTask) {
    const json story = json::parse(chart_json(test::sample_report()));
    EXPECT_EQ(story["planners"][1]["label"], "swaps|1");
    const json& charts = story["charts"];
    ASSERT_EQ(charts.size(), 3U);
    ASSERT_EQ(charts[0]["panels"].size(), 5U);
    EXPECT_EQ(charts[0]["panels"][0]["title"], "all 4 problems and directions");
    EXPECT_EQ(charts[0]["panels"][2]["title"], "first, reversed");
    // Of the second planner one run of two is not solved there.
    const json& line = charts[0]["panels"][2]["curves"][1]["line"];
    EXPECT_EQ(line.back()[1], 0.5);
    EXPECT_EQ(charts[1]["panels"].size(), 4U);
    EXPECT_EQ(charts[2]["panels"].size(), 1U);
}

TEST(ChartJson, HasTheCurvesOverAParameter) {
    BenchmarkReport report = test::sample_report();
    report.parameter = "n";
    const json charts = json::parse(chart_json(report))["charts"];
    ASSERT_EQ(charts.size(), 4U);
    EXPECT_EQ(charts[3]["title"], "Over number of ASVs");
    EXPECT_EQ(charts[3]["panels"][0]["curves"][0]["band"].size(), 2U);
}

TEST(SuccessMarkup, HasARowForEachProblemAndDirection) {
    const std::string markup = success_markup(test::sample_report());
    EXPECT_NE(markup.find("<th scope=\"row\">second, it, reversed</th>"), std::string::npos);
    EXPECT_NE(markup.find("style=\"--share: 50%\">1 of 2</td>"), std::string::npos) << markup;
}

TEST(HtmlPage, TellsWhatSpoiltTheTimes) {
    if (!has_charts()) GTEST_SKIP() << "built without Chart.js";
    BenchmarkReport report = test::sample_report();
    EXPECT_EQ(html_page(report).find("their times are spoilt"), std::string::npos);
    report.plan.jobs = 3;
    EXPECT_NE(html_page(report).find("<p class=\"spoilt\">3 runs side by side: their times are"),
              std::string::npos);
}

TEST(HtmlPage, NamesAreTextAndNothingElse) {
    if (!has_charts()) GTEST_SKIP() << "built without Chart.js";
    BenchmarkReport report = test::sample_report();
    const std::string nasty = "</script><img src=x onerror=alert(1)>@DATA@\xff";
    report.plan.planners[0].label = report.plan.problems[0].name = nasty;
    const std::string page = html_page(report);
    EXPECT_EQ(page.find("<img"), std::string::npos);
    EXPECT_NE(page.find("&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;@DATA@\\xFF"),
              std::string::npos);
    EXPECT_NE(page.find("\\u003c/script>"), std::string::npos);
}

}  // namespace
}  // namespace asv::io
