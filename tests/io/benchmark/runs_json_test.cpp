#include "io/benchmark/runs_json.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/kit/files/benchmark_report_sample.hpp"

namespace asv::io {
namespace {

TEST(RunsJson, HoldsSessionSummaryAndRuns) {
    const auto json = nlohmann::json::parse(runs_json(test::sample_report()));
    EXPECT_EQ(json["session"]["unit_s"], 0.25);
    EXPECT_EQ(json["session"]["complete"], true);
    EXPECT_EQ(json["problems"][1]["file"], "cases/second, it.txt");
    EXPECT_EQ(json["planners"][1]["planner"], "rrt-connect");
    EXPECT_EQ(json["planners"][1]["settings"]["swap-limiter"], "on");
    EXPECT_EQ(json["summary"].size(), 8U);
    EXPECT_EQ(json["summary"][0]["time_to_first_s"]["median"], 0.03125);
    EXPECT_EQ(json["summary"][0]["cost_ratio"]["median"], 1.25);
    EXPECT_EQ(json["session"]["note"], "");
    ASSERT_EQ(json["runs"].size(), 16U);
    EXPECT_EQ(json["runs"][0]["tree_nodes"], nlohmann::json::parse("[10, 20]"));
    EXPECT_EQ(json["runs"][0]["cost_history"].size(), 2U);
    EXPECT_EQ(json["runs"][7]["status"], "timeout");
    EXPECT_TRUE(json["runs"][7]["cost"].is_null());
    EXPECT_TRUE(json["runs"][7]["cost_lower_bound"].is_null());
    EXPECT_TRUE(json["runs"][7]["peak_memory_bytes"].is_null());
    EXPECT_TRUE(
        json["runs"][7]["command"].get<std::string>().ends_with("--seed 4 --time-limit 10 "
                                                                "--optimize 0 --threads 1 "
                                                                "--reverse"));
}

TEST(RunsJson, TellsWhatIsKnownToBeGreaterOnly) {
    const auto json = nlohmann::json::parse(runs_json(test::sample_report()));
    const auto& row = json["summary"][3];
    EXPECT_EQ(row["solved"], 1);
    EXPECT_NEAR(row["success_interval"][0].get<double>(), 0.0126, 1e-4);
    const auto& time = row["time_to_solution_s"];
    EXPECT_EQ(time["median"], nlohmann::json::parse(R"({"value": 5.03125, "exceeds": true})"));
    EXPECT_EQ(time["median_interval"][0]["exceeds"], false);
    EXPECT_EQ(time["median_interval"][1]["exceeds"], true);
    EXPECT_EQ(time["par2"], 10.03125);
}

TEST(RunsJson, ComparesPlanners) {
    BenchmarkReport report = test::sample_report();
    report.plan.jobs = 2;
    const auto json = nlohmann::json::parse(runs_json(report));
    ASSERT_EQ(json["comparisons"].size(), 2U);
    const auto& time = json["comparisons"][0];
    EXPECT_EQ(time["of"], "time");
    EXPECT_EQ(time["second"], "swaps|1");
    EXPECT_EQ(time["pairs"], 8);
    EXPECT_EQ(time["p"], 2.0 / 256);
    EXPECT_EQ(time["p_holm"], 4.0 / 256);
    EXPECT_EQ(json["session"]["note"], "2 runs side by side: their times are spoilt.");
}

}  // namespace
}  // namespace asv::io
