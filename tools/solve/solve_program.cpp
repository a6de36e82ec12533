#include "tools/solve/solve_program.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>

#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/solution/trajectory_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/common/motion_limits_options.hpp"
#include "tools/common/progress_line.hpp"
#include "tools/solve/arguments.hpp"
#include "tools/solve/batch/batch_program.hpp"
#include "tools/solve/run_report.hpp"
#include "tools/solve/run_watch.hpp"

namespace asv::tools {

namespace {

using Arguments = SolveArguments;

/// When everything has to be over; none beyond what a clock can count.
std::optional<core::Clock::time_point> moment_of_limit(const Arguments& arguments) {
    constexpr double never = 1e9;  // seconds
    const std::chrono::duration<double> limit(arguments.solve.time_limit);
    if (limit.count() > never) return std::nullopt;
    return arguments.started + std::chrono::duration_cast<core::Clock::duration>(limit);
}

FileRoles roles_of(const Arguments& arguments) {
    FileRoles roles;
    roles.add_input("PROBLEM", arguments.problem);
    roles.add_output("SOLUTION", arguments.solution);
    roles.add_output("--stats", arguments.stats);
    roles.add_output("--certificate", arguments.certificate);
    roles.add_output("--trajectory", arguments.trajectory);
    roles.add_output("--trees", arguments.trees);
    return roles;
}

void require_format(const std::string& trajectory) {
    if (!trajectory.empty() && !io::trajectory_format(trajectory))
        throw UsageError("--trajectory " + trajectory +
                         ": the name has to end in .csv, .json or .yaml");
}

void require_usable(const Arguments& arguments, const core::Problem& problem) {
    for (const std::string* output : {&arguments.solution, &arguments.stats, &arguments.certificate,
                                      &arguments.trajectory, &arguments.trees})
        if (!output->empty()) io::require_writable(*output);
    require_usable_planner(arguments, problem.body_kind());
}

/// Solves it as the arguments ask for, with what the watch and the terminal want to know.
core::SolveResult solve(const CommandLine& command_line, const Arguments& arguments,
                        const SolveSite& site, const core::Problem& problem, RunWatch& watch) {
    ProgressLine line(!command_line.quiet());
    core::SolveOptions options = arguments.solve;
    options.stop = watch.interrupted();
    options.keep_trees = !arguments.trees.empty();
    options.on_path = [&](double seconds) { watch.note_path(seconds); };
    if (line.visible())
        options.on_progress = [&](const core::SolveProgress& progress) {
            line.show(progress_text(progress));
        };
    options.elapsed_before =
        std::chrono::duration<double>(core::Clock::now() - arguments.started).count();
    return site.solve(arguments, problem, options);
}

/// The solution first, since it matters most, and the trees last, which are the largest. Returns
/// the seconds of the trajectory, where one is wanted.
std::optional<double> write_outputs(const Arguments& arguments, const core::Problem& problem,
                                    const core::SolveResult& result, RunWatch& watch) {
    std::optional<double> duration;
    if (result.solution) {
        watch.enter(Stage::writing_solution, is_stream(arguments.solution));
        io::write_solution(arguments.solution, *result.solution);
    }
    if (!arguments.stats.empty()) {
        watch.enter(Stage::writing_statistics, is_stream(arguments.stats));
        write_statistics(arguments, problem, result);
    }
    if (!arguments.certificate.empty()) {
        watch.enter(Stage::writing_certificate, is_stream(arguments.certificate));
        write_certificate(arguments, problem, result.status);
    }
    if (result.solution && !arguments.trajectory.empty()) {
        watch.enter(Stage::writing_trajectory, is_stream(arguments.trajectory));
        duration = write_trajectory(arguments, problem, result);
    }
    if (!arguments.trees.empty()) {
        watch.enter(Stage::writing_trees, is_stream(arguments.trees));
        write_trees(arguments, result, problem.asv_count());
    }
    return duration;
}

ExitCode solve_file(const CommandLine& command_line, Arguments& arguments, const SolveSite& site) {
    require_format(arguments.trajectory);
    FileRoles roles = roles_of(arguments);
    roles.require_distinct();
    std::atomic<core::SolveStatus> status = core::SolveStatus::timeout;
    RunWatch watch(moment_of_limit(arguments),
                   [&](const CutOff& at) { return give_up(arguments, at, status); });
    const io::ProblemFile file = io::read_problem(arguments.problem, arguments.reading);
    command_line.print(file.warnings);
    roles.add_maps(file);
    roles.require_distinct();
    require_usable(arguments, file.problem);
    if (!arguments.trajectory.empty())
        arguments.limits = motion_limits(arguments.limits, file.problem);
    warn_of_idle_settings(arguments, file.problem);
    watch.enter(Stage::solving);
    try {
        const core::SolveResult result = solve(command_line, arguments, site, file.problem, watch);
        status = result.status;
        const std::optional<double> duration =
            write_outputs(arguments, file.problem, result, watch);
        if (!command_line.quiet()) report(arguments, result, duration);
        if (!command_line.quiet() && site.summary)
            std::cerr << "asv-solve: " << site.summary() << '\n';
        return exit_code(result.status);
    } catch (const core::InvalidEnds& invalid) {
        report_invalid_ends(arguments, file, invalid);
        return ExitCode::bad_input;
    }
}

}  // namespace

int run_solve_program(int argc, const char* const* argv, const SolveSite& site) {
    CommandLine command_line(
        "asv-solve",
        "Plans a motion for a chain of ASVs among obstacles, shortens it, checks it and writes it "
        "as primitive steps.",
        "asv-solve testcases/7ASV.txt 7ASV-solution.txt --seed 7 --stats 7ASV-stats.json");
    Arguments arguments;
    // The system has been busy with the program before it got here.
    arguments.started =
        core::Clock::now() - std::chrono::duration_cast<core::Clock::duration>(
                                 std::chrono::duration<double>(processor_seconds()));
    add_options(command_line.options(), arguments);
    if (site.threads > 0) arguments.solve.threads = site.threads;
    return command_line.run(argc, argv, [&] {
        arguments.quiet = command_line.quiet();
        arguments.solve.planner = chosen_planner(arguments);
        if (arguments.batch.empty()) return solve_file(command_line, arguments, site);
        if (!site.alone) throw UsageError("--batch is for one process, not for a race of many");
        return answer_batch(command_line, arguments);
    });
}

}  // namespace asv::tools
