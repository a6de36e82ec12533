#include "io/benchmark/runs_csv.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/kit/files/benchmark_report_sample.hpp"
#include "tests/kit/files/text.hpp"

namespace asv::io {
namespace {

using test::lines_of;

TEST(RunsCsv, HasALineForEachRun) {
    const auto lines = lines_of(runs_csv(test::sample_report()));
    ASSERT_EQ(lines.size(), 17U);
    EXPECT_EQ(lines[0],
              "problem,planner,settings,direction,seed,threads,status,reason,time_to_first_s,"
              "time_to_first_u,time_total_s,cost_first,cost_of_search,cost,cost_lower_bound,"
              "cost_ratio,primitive_steps,primitive_steps_lower_bound,tree_nodes,iterations,"
              "state_checks,edge_checks,peak_memory_bytes,jobs");
    EXPECT_EQ(lines[1],
              "first,auto,auto,forward,3,1,solved,,0.015625,0.0625,0.515625,3,2.75,2.5,2,1.25,"
              "700,600,30,7,400,50,3145728,1");
    EXPECT_EQ(lines[8],
              "first,swaps|1,rrt-connect swap-limiter=on,reversed,4,1,timeout,no path found: "
              "deadline,,,10,,,,,,0,,1000,0,0,0,,1");
    EXPECT_TRUE(lines[9].starts_with("\"second, it\",auto,")) << lines[9];
}

// A spreadsheet takes what begins like this for a formula, and runs it.
TEST(RunsCsv, NamesAreNoFormulas) {
    for (const char* first : {"=", "+", "-", "@"}) {
        BenchmarkReport report = test::sample_report();
        report.plan.problems[0].name = std::string(first) + "HYPERLINK(\"x\")";
        report.plan.planners[0].label = "a\x1b\n=1";
        const auto lines = lines_of(runs_csv(report));
        ASSERT_EQ(lines.size(), 17U);
        EXPECT_TRUE(lines[1].starts_with("\"'" + std::string(first) +
                                         "HYPERLINK(\"\"x\"\")\",a\\x1B\\x0A=1,"))
            << lines[1];
    }
}

}  // namespace
}  // namespace asv::io
