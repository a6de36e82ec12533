#pragma once

#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

#include "tools/bench/runs/launcher_process.hpp"
#include "tools/bench/runs/run_crew.hpp"

namespace asv::tools {

/// Runs of a plan, each in a process of its own that begins as a process of asv-solve does: with an
/// empty heap and cold pages. In one process for all runs the later ones find everything warm, and
/// those of a few milliseconds take half the time that a user sees. There is one launcher process
/// for each job.
class RunLauncher : public RunCrew {
  public:
    /// Precondition: no thread has been started, and the plan outlives this. Throws
    /// std::system_error where the system grants no process.
    explicit RunLauncher(const core::BenchmarkPlan& plan);

    /// As many as the plan has jobs, or fewer where the system grants no more processes.
    std::size_t size() const override { return idle_.size(); }

    core::BenchmarkRun run(const core::RunPlace& place, const std::stop_token& abort) override;

  private:
    std::unique_ptr<LauncherProcess> take();

    std::mutex mutex_;
    std::vector<std::unique_ptr<LauncherProcess>> idle_;
};

}  // namespace asv::tools
