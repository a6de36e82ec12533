#pragma once

#include <mutex>
#include <stop_token>
#include <vector>

#include <sys/types.h>

#include "core/benchmark/run.hpp"

namespace asv::tools {

/// Runs of a plan, each in a process of its own that begins as a process of asv-solve does: with an
/// empty heap and cold pages. In one process for all runs the later ones find everything warm, and
/// those of a few milliseconds take half the time that a user sees.
///
/// A process that is forked beside threads inherits their locks, which nobody opens any more. So
/// there is one launcher for each job (see jobs()), forked while there are no threads; it forks the
/// runs.
class RunLauncher {
  public:
    /// Precondition: no thread has been started, and the plan outlives this. Throws
    /// std::system_error where the system grants no process.
    explicit RunLauncher(const core::BenchmarkPlan& plan);
    ~RunLauncher();
    RunLauncher(const RunLauncher&) = delete;
    RunLauncher& operator=(const RunLauncher&) = delete;

    /// Runs side by side: as many as the plan asks for, or fewer where the system grants no more
    /// processes.
    std::size_t jobs() const { return idle_.size(); }

    /// core::run_once(), or run_external(), in a process of its own; from as many threads at once
    /// as there are jobs. Fills in the peak memory of the run. A process that ends in any other way
    /// than by itself is a fault of the run. abort ends it.
    core::BenchmarkRun run(const core::RunPlace& place, const std::stop_token& abort);

  private:
    struct Process {
        pid_t id = 0;
        int socket = -1;  ///< places go in, outcomes come out
    };

    Process start() const;
    Process take();
    void give_back(Process process);

    const core::BenchmarkPlan& plan_;
    std::mutex mutex_;
    std::vector<Process> idle_;
};

}  // namespace asv::tools
