#include "io/benchmark/ompl_log.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/kit/files/benchmark_report_sample.hpp"
#include "tests/kit/files/text.hpp"

namespace asv::io {
namespace {

using test::lines_of;

TEST(OmplLog, ReadsAsItsScriptReadsIt) {
    const BenchmarkReport report = test::sample_report();
    const auto all = experiments(report);
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all[1].name, "first-reversed");
    EXPECT_EQ(all[2].name, "second,_it");
    const auto lines = lines_of(ompl_log(report, all[1]));
    EXPECT_EQ(lines[0], "ASV version 1.2.3");
    EXPECT_EQ(lines[1], "Experiment first-reversed");
    EXPECT_EQ(lines[2], "0 experiment properties");
    EXPECT_EQ(lines[3], "Running on host");
    EXPECT_EQ(lines[4], "Starting at 1970-01-01 00:00:00");
    EXPECT_EQ(lines[5], "<<<|");
    const auto at = [&](const std::string& line, std::size_t from = 0) {
        const auto found =
            std::find(lines.begin() + static_cast<std::ptrdiff_t>(from), lines.end(), line);
        EXPECT_NE(found, lines.end()) << line;
        return static_cast<std::size_t>(found - lines.begin());
    };
    const std::size_t facts = at("3 is the random seed");
    EXPECT_EQ(lines[facts - 1], "|>>>");
    EXPECT_EQ(lines[facts + 1], "10 seconds per run");
    EXPECT_EQ(lines[facts + 2], "0 MB per run");
    EXPECT_EQ(lines[facts + 3], "2 runs per planner");
    EXPECT_EQ(lines[facts + 4], "12.5 seconds spent to collect the data");
    EXPECT_EQ(lines[facts + 5], "1 enum type");
    EXPECT_EQ(lines[facts + 6],
              "status|Unknown status|Invalid start|Invalid goal|Unrecognized goal type|Timeout|"
              "Approximate solution|Exact solution|Crash|Abort|Infeasible|No path|"
              "Memory limit|Invalid solution");
    EXPECT_EQ(lines[facts + 7], "2 planners");
    EXPECT_EQ(lines[facts + 8], "auto");
    const std::size_t runs = at("2 runs");
    EXPECT_EQ(lines[runs + 1],
              "0.015625; 3; 6; 1; 0; 1; 3; 0.5; 2.5; 1; 700; 30; 7; 400; 50; 2; 1.25; 0.0625; "
              "0.515625; 3; ");
    EXPECT_EQ(lines[runs + 3], "2 progress properties for each run");
    EXPECT_EQ(lines[runs + 7], "0.015625,3,;0.265625,2.5,;");
    EXPECT_EQ(lines[runs + 9], ".");
    EXPECT_EQ(lines[runs + 10], "swaps|1");
    const std::size_t others = at("2 runs", at("swaps|1"));
    EXPECT_EQ(lines[others + 2], "10; ; 4; 0; 0; ; ; ; ; ; ; 1000; 0; 0; 0; ; ; 40; 10; 4; ");
    EXPECT_EQ(lines.back(), ".");
}

TEST(OmplLog, SeveralExperimentsHaveSeveralFiles) {
    const Experiment experiment{"maps/7ASV.txt-reversed", 0, core::Direction::reversed};
    EXPECT_EQ(ompl_log_file("logs/bench.log", experiment, false), "logs/bench.log");
    EXPECT_EQ(ompl_log_file("logs/bench.log", experiment, true),
              "logs/bench-maps_7ASV.txt-reversed.log");
}

}  // namespace
}  // namespace asv::io
