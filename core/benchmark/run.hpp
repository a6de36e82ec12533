#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/benchmark/plan.hpp"

/// Running a benchmark: a plan goes in, what each run found and spent comes out.

namespace asv::core {

/// How a run ended: what solve() tells, and what only the keeper of its process sees.
enum class RunStatus {
    solved,
    timeout,
    infeasible,
    interrupted,
    no_path,       ///< it gave up before its time was over
    memory_limit,  ///< it wanted more memory than it may have
    crash,         ///< a signal ended it, or it ended in error
    invalid        ///< its path violates a requirement
};

inline constexpr std::array all_run_statuses{
    RunStatus::solved,  RunStatus::timeout,      RunStatus::infeasible, RunStatus::interrupted,
    RunStatus::no_path, RunStatus::memory_limit, RunStatus::crash,      RunStatus::invalid};

/// "solved", "timeout", "no-path", ...
std::string_view name(RunStatus status);

RunStatus run_status(SolveStatus status);

/// One run and its outcome.
struct BenchmarkRun {
    RunPlace place;
    RunStatus status = RunStatus::timeout;
    std::string reason;  ///< why there is no solution; empty when solved
    SolveStatistics spent;
    std::size_t primitive_steps = 0;
    std::optional<std::size_t> peak_memory_bytes;  ///< of its process, where it has one of its own
    std::string fault;  ///< a bug: what was thrown, or what is wrong with the solution

    bool solved() const { return status == RunStatus::solved && fault.empty(); }
};

/// One run of the plan: solve(), then fault_of() what it found. Whatever solve() throws, but lack
/// of memory, is a fault of the run. Precondition: the planner is not external.
BenchmarkRun run_once(const BenchmarkPlan& plan, const RunPlace& place,
                      const std::stop_token& abort = {});

/// Who looks on. With several workers before() and after() are called from several threads, one at
/// a time.
struct BenchmarkWatch {
    std::function<void(const RunPlace&)> before = {};     ///< a run begins
    std::function<void(const BenchmarkRun&)> after = {};  ///< a run has ended
    std::stop_token enough = {};                          ///< no further run begins
    std::stop_token abort = {};                           ///< the runs at work end, are dropped
    /// Does a run: here, or in a process of its own.
    std::function<BenchmarkRun(const BenchmarkPlan&, const RunPlace&, const std::stop_token&)>
        perform = run_once;
    std::size_t workers = 0;  ///< runs at once, on all machines; 0 for the jobs of the plan
};

/// Runs the plan and checks each solution once more, the motion between its steps included. Seeds
/// are the outer loop of each problem and planners the inner one, so that a machine that slows down
/// meanwhile slows all planners down. Ends early after the first run with a fault. The runs that
/// took place are returned by problem, direction, planner and seed. Throws std::invalid_argument as
/// solve() does, before anything has run.
std::vector<BenchmarkRun> run_benchmark(const BenchmarkPlan& plan,
                                        const BenchmarkWatch& watch = {});

/// The same for these places of the plan alone.
std::vector<BenchmarkRun> run_benchmark(const BenchmarkPlan& plan, std::vector<RunPlace> which,
                                        const BenchmarkWatch& watch = {});

/// Sorts the runs as they are told: by problem, direction, planner and seed.
void sort_as_told(std::vector<BenchmarkRun>& runs);

/// What the continuous check says against the solution; empty for a valid one.
std::string fault_of(const Problem& problem, const Solution& solution);

}  // namespace asv::core
