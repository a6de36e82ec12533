#include "tools/bench/runs/sweep.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "core/benchmark/machine_unit.hpp"
#include "tools/bench/runs/machine.hpp"
#include "tools/bench/runs/run_progress.hpp"
#include "tools/common/interrupt.hpp"

namespace asv::tools {

namespace {

io::BenchmarkSession begin_session() {
    io::BenchmarkSession session{ASV_VERSION, host_name(), cpu_name(),
                                 std::thread::hardware_concurrency(),
                                 std::chrono::system_clock::now()};
    session.unit_before = session.unit_after = core::seconds_per_million_checks();
    return session;
}

/// Runs them; true when that was interrupted.
bool run_all(io::BenchmarkReport& report, std::vector<core::RunPlace> places, Journal* journal,
             const HireCrew& hire, bool quiet) {
    core::BenchmarkPlan& plan = report.plan;
    const std::unique_ptr<RunCrew> crew = hire(plan);
    plan.jobs = std::min(plan.jobs, crew->size());
    const InterruptWatch interrupt;
    RunProgress progress(plan, places.size(), !quiet);
    core::BenchmarkWatch watch;
    watch.before = [&](const core::RunPlace& place) { progress.begin(place); };
    watch.after = [&](const core::BenchmarkRun& run) {
        if (journal != nullptr && run.fault.empty()) journal->add(plan, run);
        progress.end();
    };
    watch.perform = [&](const core::BenchmarkPlan&, const core::RunPlace& place,
                        const std::stop_token& abort) { return crew->run(place, abort); };
    watch.workers = crew->size();
    watch.abort = interrupt.token();
    std::vector<core::BenchmarkRun> done = core::run_benchmark(plan, std::move(places), watch);
    std::move(done.begin(), done.end(), std::back_inserter(report.runs));
    core::sort_as_told(report.runs);
    if (const std::string summary = crew->summary(); !quiet && !summary.empty())
        progress.tell("asv-bench: " + summary);
    return watch.abort.stop_requested();
}

}  // namespace

SweepEnd run_sweep(io::BenchmarkReport& report, std::vector<core::RunPlace> places,
                   std::vector<io::BenchmarkSession> earlier, Journal* journal,
                   const HireCrew& hire, bool quiet) {
    const auto begun = core::Clock::now();
    report.session = begin_session();
    if (journal != nullptr) journal->begin(report);
    SweepEnd end;
    end.interrupted = run_all(report, std::move(places), journal, hire, quiet);
    const auto fault = std::find_if(report.runs.begin(), report.runs.end(),
                                    [](const auto& run) { return !run.fault.empty(); });
    if (fault != report.runs.end()) {
        end.fault = *fault;
        return end;
    }
    // Who has interrupted the runs does not want to wait for another measurement.
    if (!end.interrupted) report.session.unit_after = core::seconds_per_million_checks();
    report.session.total = std::chrono::duration<double>(core::Clock::now() - begun).count();
    if (journal != nullptr) journal->end(report);
    earlier.push_back(std::move(report.session));
    report.session = io::joined(std::move(earlier));
    return end;
}

}  // namespace asv::tools
