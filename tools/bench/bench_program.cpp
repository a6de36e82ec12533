#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include "tools/bench/bench_arguments.hpp"
#include "tools/bench/bench_outputs.hpp"
#include "tools/bench/bench_plan.hpp"
#include "tools/bench/bench_task.hpp"
#include "tools/bench/runs/sweep.hpp"
#include "tools/common/command_line.hpp"

namespace {

namespace core = asv::core;
namespace io = asv::io;
using asv::tools::BenchArguments;
using asv::tools::BenchTask;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::FileRoles;
using asv::tools::SweepEnd;

/// Reports a run that must not be: its message and the command that repeats it.
ExitCode report_fault(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run) {
    std::cerr << "asv-bench: a bug, nothing was written: " << run.fault
              << "\nIt comes again with\n  " << io::solve_command(plan, run.place) << '\n';
    return ExitCode::internal;
}

ExitCode run_and_write(const CommandLine& command_line, const BenchArguments& arguments,
                       BenchTask& task) {
    SweepEnd end;
    if (!task.missing.empty())
        end = run_sweep(task.report, std::move(task.missing), std::move(task.earlier),
                        task.journal ? &*task.journal : nullptr, command_line.quiet());
    if (end.fault) return report_fault(task.report.plan, *end.fault);
    if (task.report.runs.empty()) {
        std::cerr << "asv-bench: "
                  << (end.interrupted ? "interrupted before a run had ended" : "there are no runs")
                  << "; nothing was written\n";
        return end.interrupted ? ExitCode::interrupted : ExitCode::bad_input;
    }
    write_results(arguments.outputs, task.report, end.interrupted);
    return ExitCode::done;
}

ExitCode bench(const CommandLine& command_line, BenchArguments& arguments) {
    complete(arguments);
    FileRoles roles;
    for (const std::string& file : arguments.problems) roles.add_input("PROBLEM", file);
    for (const std::string& file : arguments.from) roles.add_input("--from", file);
    roles.add_output("--resume", arguments.resume);
    add_roles(arguments.outputs, roles);
    roles.require_distinct();
    BenchTask task;
    if (!prepare(command_line, arguments, roles, task)) return ExitCode::bad_input;
    const core::BenchmarkPlan& plan = task.report.plan;
    for (const std::filesystem::path& file :
         asv::tools::log_files(plan, arguments.outputs.ompl_log))
        roles.add_output("--ompl-log", file);
    roles.require_distinct();
    if (!task.missing.empty()) {
        asv::tools::require_usable(plan);
        asv::tools::warn_of_idle_settings(command_line, plan);
    }
    require_places(arguments.outputs);
    resume(arguments, task);
    return run_and_write(command_line, arguments, task);
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
    BenchArguments arguments;
    add_options(command_line.options(), arguments);
    return command_line.run(argc, argv, [&] { return bench(command_line, arguments); });
} catch (...) {
    return asv::tools::report_failed_start("asv-bench");
}
