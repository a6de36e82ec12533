#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/benchmark/machine_unit.hpp"
#include "core/benchmark/run.hpp"
#include "tools/bench/bench_outputs.hpp"
#include "tools/bench/bench_plan.hpp"
#include "tools/bench/machine.hpp"
#include "tools/bench/run_launcher.hpp"
#include "tools/bench/run_progress.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/interrupt.hpp"
#include "tools/common/number_options.hpp"
#include "tools/common/reading.hpp"

namespace {

namespace core = asv::core;
namespace io = asv::io;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::RunProgress;
using asv::tools::UsageError;
using std::filesystem::path;

struct Arguments {
    std::vector<std::string> problems;
    std::vector<std::string> planners = {"auto"};
    std::string direction = "forward";
    asv::tools::BenchOutputs outputs;
    core::BenchmarkPlan plan;
    io::ReadOptions reading;
};

constexpr std::uint64_t max_seeds = 1'000'000;

void add_plan_options(CLI::App& app, Arguments& arguments) {
    core::BenchmarkPlan& plan = arguments.plan;
    app.add_option("PROBLEMS", arguments.problems,
                   "Problem files and scenarios; - for standard input")
        ->type_name(asv::tools::problem_file)
        ->required();
    asv::tools::add_reading_options(app, arguments.reading);
    app.add_option("--planner", arguments.planners,
                   "\"[LABEL:] NAME [KEY=VALUE]...\": a planner with settings, see asv-solve "
                   "--list-planners; \"all\" for every planner; may be repeated")
        ->type_name("PLANNER|all")
        ->allow_extra_args(false)
        ->capture_default_str();
    app.add_option("--seeds", plan.seeds, "Runs of each planner on each problem in each direction")
        ->transform(asv::tools::whole_number(1, max_seeds))
        ->capture_default_str();
    app.add_option("--first-seed", plan.first_seed, "The first seed; the others follow it")
        ->transform(
            asv::tools::whole_number(0, std::numeric_limits<std::uint64_t>::max() - max_seeds))
        ->capture_default_str();
    app.add_option("--direction", arguments.direction, "forward, reversed (goal to start) or both")
        ->check(CLI::IsMember({"forward", "reversed", "both"}))
        ->capture_default_str();
    app.add_option("--time-limit", plan.time_limit, "Seconds of wall clock for each run")
        ->transform(asv::tools::number_from(0))
        ->capture_default_str();
    app.add_option("--optimize", plan.optimize,
                   "Improvement after the first path, in seconds of work, as in asv-solve")
        ->transform(asv::tools::number_from(0))
        ->capture_default_str();
    app.add_option("--threads", plan.threads, "Threads of each run")
        ->transform(asv::tools::whole_number(1, asv::tools::max_threads))
        ->capture_default_str();
    app.add_option("--jobs", plan.jobs,
                   "Runs side by side: sooner done, but their times are spoilt")
        ->transform(asv::tools::whole_number(1, asv::tools::max_threads))
        ->capture_default_str();
}

void complete_plan(Arguments& arguments) {
    core::BenchmarkPlan& plan = arguments.plan;
    plan.planners = asv::tools::parse_planners(arguments.planners);
    plan.directions.clear();
    if (arguments.direction != "reversed") plan.directions.push_back(core::Direction::forward);
    if (arguments.direction != "forward") plan.directions.push_back(core::Direction::reversed);
}

struct Runs {
    std::vector<core::BenchmarkRun> done;
    bool interrupted = false;
};

Runs run_all(core::BenchmarkPlan& plan, bool quiet) {
    asv::tools::RunLauncher launcher(plan);
    plan.jobs = launcher.jobs();
    const asv::tools::InterruptWatch interrupt;
    RunProgress progress(plan, !quiet);
    core::BenchmarkWatch watch;
    watch.before = [&](const core::RunPlace& place) { progress.begin(place); };
    watch.after = [&](const core::BenchmarkRun&) { progress.end(); };
    watch.perform = [&](const core::BenchmarkPlan&, const core::RunPlace& place,
                        const std::stop_token& abort) { return launcher.run(place, abort); };
    watch.abort = interrupt.token();
    std::vector<core::BenchmarkRun> done = core::run_benchmark(plan, watch);
    return {std::move(done), watch.abort.stop_requested()};
}

/// Reports a run that must not be: its message and the command that repeats it.
ExitCode report_fault(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run) {
    std::cerr << "asv-bench: a bug, nothing was written: " << run.fault
              << "\nIt comes again with\n  " << io::solve_command(plan, run.place) << '\n';
    return ExitCode::internal;
}

ExitCode bench(const CommandLine& command_line, Arguments& arguments) {
    complete_plan(arguments);
    complete(arguments.outputs);
    asv::tools::FileRoles roles;
    for (const std::string& file : arguments.problems) roles.add_input("PROBLEM", file);
    add_roles(arguments.outputs, roles);
    roles.require_distinct();
    core::BenchmarkPlan& plan = arguments.plan;
    if (!asv::tools::read_problems(command_line, arguments.problems, arguments.reading, roles,
                                   plan.problems))
        return ExitCode::bad_input;
    for (const path& file : asv::tools::log_files(plan, arguments.outputs.ompl_log))
        roles.add_output("--ompl-log", file);
    roles.require_distinct();
    asv::tools::require_usable(plan);
    asv::tools::warn_of_idle_settings(command_line, plan);
    require_places(arguments.outputs);

    io::BenchmarkReport report;
    report.session = {ASV_VERSION, asv::tools::host_name(), asv::tools::cpu_name(),
                      std::thread::hardware_concurrency(), std::chrono::system_clock::now()};
    const auto begun = core::Clock::now();
    report.session.unit_before = core::seconds_per_million_checks();
    Runs runs = run_all(plan, command_line.quiet());
    report.runs = std::move(runs.done);
    for (const core::BenchmarkRun& run : report.runs)
        if (!run.fault.empty()) return report_fault(plan, run);
    if (report.runs.empty()) {
        std::cerr << "asv-bench: interrupted before a run had ended; nothing was written\n";
        return ExitCode::interrupted;
    }
    // Who has interrupted the runs does not want to wait for another measurement.
    report.session.unit_after =
        runs.interrupted ? report.session.unit_before : core::seconds_per_million_checks();
    report.session.total = std::chrono::duration<double>(core::Clock::now() - begun).count();
    report.plan = std::move(plan);

    write_results(arguments.outputs, report, runs.interrupted);
    return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) try {
    CommandLine command_line(
        "asv-bench",
        "Runs planners on problems with many seeds, each run as asv-solve would and in a process "
        "of its own, checks every "
        "solution once more, and tells how it went. Runs that find no path are results: the exit "
        "code is 0 all the same. Ctrl-C ends it at once; the results of the runs that have ended "
        "are "
        "written.",
        "asv-bench testcases/3ASV.txt testcases/7ASV.txt --planner auto --planner \"swaps: "
        "rrt-connect swap-limiter=on\" --direction both --csv runs.csv");
    Arguments arguments;
    add_plan_options(command_line.options(), arguments);
    add_output_options(command_line.options(), arguments.outputs);
    return command_line.run(argc, argv, [&] { return bench(command_line, arguments); });
} catch (...) {
    return asv::tools::report_failed_start("asv-bench");
}
