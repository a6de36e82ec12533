#include "tools/bench/bench_program.hpp"

#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include "tools/bench/bench_arguments.hpp"
#include "tools/bench/bench_outputs.hpp"
#include "tools/bench/bench_plan.hpp"
#include "tools/bench/bench_task.hpp"
#include "tools/bench/problem_arguments.hpp"
#include "tools/bench/runs/sweep.hpp"
#include "tools/common/command_line.hpp"

namespace asv::tools {

namespace {

/// Reports a run that must not be: its message and the command that repeats it.
ExitCode report_fault(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run) {
    std::cerr << "asv-bench: a bug, nothing was written: " << run.fault
              << "\nIt comes again with\n  " << io::solve_command(plan, run.place) << '\n';
    return ExitCode::internal;
}

ExitCode run_and_write(const CommandLine& command_line, const BenchArguments& arguments,
                       const RunSite& site, BenchTask& task) {
    SweepEnd end;
    if (!task.missing.empty())
        end = run_sweep(task.report, std::move(task.missing), std::move(task.earlier),
                        task.journal ? &*task.journal : nullptr, site.hire, command_line.quiet());
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

ExitCode bench(const CommandLine& command_line, BenchArguments& arguments, const RunSite& site) {
    if (arguments.list) {
        std::cout << io::format_set(chosen_problems(arguments));
        return ExitCode::done;
    }
    complete(arguments);
    FileRoles roles;
    add_problem_roles(arguments.problems, roles);
    for (const std::string& file : arguments.from) roles.add_input("--from", file);
    roles.add_output("--resume", arguments.resume);
    add_roles(arguments.outputs, roles);
    roles.require_distinct();
    BenchTask task;
    if (!prepare(command_line, arguments, roles, task)) return ExitCode::bad_input;
    const core::BenchmarkPlan& plan = task.report.plan;
    for (const std::filesystem::path& file : log_files(plan, arguments.outputs.ompl_log))
        roles.add_output("--ompl-log", file);
    roles.require_distinct();
    if (!task.missing.empty()) {
        require_usable(plan);
        warn_of_idle_settings(command_line, plan);
    }
    require_places(arguments.outputs);
    resume(arguments, task);
    return run_and_write(command_line, arguments, site, task);
}

/// The site decides how many runs are side by side, where it does.
void take_jobs_of(const RunSite& site, const CLI::Option& jobs, BenchArguments& arguments) {
    if (site.jobs == 0) return;
    if (jobs.count() > 0) throw UsageError("--jobs: under MPI every rank makes one run at a time");
    arguments.plan.jobs = site.jobs;
}

}  // namespace

int run_bench_program(int argc, const char* const* argv, const RunSite& site) {
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
    return command_line.run(argc, argv, [&] {
        take_jobs_of(site, *command_line.options().get_option("--jobs"), arguments);
        return bench(command_line, arguments, site);
    });
}

}  // namespace asv::tools
