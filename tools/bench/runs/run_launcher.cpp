#include "tools/bench/runs/run_launcher.hpp"

#include <system_error>
#include <utility>

#include "tools/bench/runs/run_bytes.hpp"

namespace asv::tools {

RunLauncher::RunLauncher(const core::BenchmarkPlan& plan) {
    const auto serve = [&plan](int socket) { serve_runs(plan, socket); };
    idle_.push_back(std::make_unique<LauncherProcess>(serve));
    try {
        while (idle_.size() < plan.jobs) idle_.push_back(std::make_unique<LauncherProcess>(serve));
    } catch (const std::system_error&) {
        // The system grants no more processes: those that there are have to do.
    }
}

std::unique_ptr<LauncherProcess> RunLauncher::take() {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<LauncherProcess> process = std::move(idle_.back());
    idle_.pop_back();
    return process;
}

core::BenchmarkRun RunLauncher::run(const core::RunPlace& place, const std::stop_token& abort) {
    std::unique_ptr<LauncherProcess> process = take();
    const auto answer = process->ask(place_bytes(place), [&] { return abort.stop_requested(); });
    core::BenchmarkRun run;
    run.place = place;
    if (answer || !abort.stop_requested()) run = answered_run(answer, place);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(process));
    return run;
}

}  // namespace asv::tools
