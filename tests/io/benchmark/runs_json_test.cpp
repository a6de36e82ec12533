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

}  // namespace
}  // namespace asv::io
