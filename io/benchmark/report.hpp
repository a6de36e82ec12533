#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "core/benchmark/plan.hpp"
#include "core/benchmark/run.hpp"

namespace asv::io {

/// Where and when a benchmark ran.
struct BenchmarkSession {
    std::string version;  ///< of this program
    std::string host, cpu;
    std::size_t processors = 1;
    std::chrono::system_clock::time_point started;
    double total = 0;                        ///< seconds that all took together
    double unit_before = 1, unit_after = 1;  ///< seconds of 10^6 scalar state checks
    /// The sessions that its runs are from, where that is not one; none of them has parts.
    std::vector<BenchmarkSession> parts = {};

    /// The unit of the session: the mean of both.
    double unit() const { return (unit_before + unit_after) / 2; }
};

/// What can be said of several sessions together: begun with the first, as long as all of them, the
/// means of their units. Precondition: at least one; each of one version.
BenchmarkSession joined(std::vector<BenchmarkSession> sessions);

/// All that the files of a benchmark tell.
struct BenchmarkReport {
    core::BenchmarkPlan plan;
    std::vector<core::BenchmarkRun> runs;  ///< by problem, direction, planner and seed
    BenchmarkSession session;
    /// Of the problems, over which curves are drawn (core/benchmark/parameter_curves.hpp); empty
    /// for none.
    std::string parameter = {};

    /// Were all runs of the plan made?
    bool complete() const { return runs.size() == core::run_count(plan); }
};

/// "rrt-connect swap-limiter=on", "exec ./planner {problem} {solution}": name and settings or
/// command, as --planner of asv-bench takes them.
std::string planner_text(const core::BenchmarkPlanner& planner);

/// A call of asv-solve that repeats the run, quoted for a shell, behind one of asv-generate where
/// the problem is no file; or of the program that is the planner, whose problem, where it is
/// reversed, is to be written as reversed.txt first.
std::string solve_command(const core::BenchmarkPlan& plan, const core::RunPlace& place);

/// "2026-11-25 16:06:21", in UTC.
std::string utc_text(std::chrono::system_clock::time_point time);

/// At most four significant digits and no exponent: "0.0123", "12.35", "1235", "123456".
std::string short_number(double value);

}  // namespace asv::io
