#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/resource.h>

#include "core/solve/solve.hpp"
#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/solution/statistics_file.hpp"
#include "io/solution/trees_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/common/interrupt.hpp"
#include "tools/common/progress_line.hpp"
#include "tools/common/reading.hpp"
#include "tools/solve/planner_list.hpp"
#include "tools/solve/time_limit_watch.hpp"

namespace {

namespace core = asv::core;
namespace io = asv::io;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::ProgressLine;
using asv::tools::TimeLimitWatch;

struct Arguments {
    std::string problem, solution, stats, trees;
    std::string planner = "auto";
    std::vector<std::string> settings;
    bool markdown = false;
    core::SolveOptions solve;
    io::ReadOptions reading;
    core::Clock::time_point started = core::Clock::now();
};

void add_options(CLI::App& app, Arguments& arguments) {
    core::SolveOptions& solve = arguments.solve;
    app.add_option("PROBLEM", arguments.problem, "Problem file; - for standard input")->required();
    app.add_option("SOLUTION", arguments.solution, "Solution file to write; - for standard output")
        ->required();
    app.add_option("--planner", arguments.planner, "Planner, see --list-planners")
        ->capture_default_str();
    app.add_option("--set", arguments.settings,
                   "KEY=VALUE: a setting of the planner, see --list-planners; may be repeated")
        ->allow_extra_args(false);
    app.add_option("--seed", solve.seed, "Seed of all random draws")->capture_default_str();
    app.add_option("--time-limit", solve.time_limit, "Seconds of wall clock for everything")
        ->check(asv::tools::finite_and_not_negative())
        ->capture_default_str();
    app.add_option("--optimize", solve.optimize,
                   "Improvement after the first solution, in seconds of work of a 2.8 GHz core; "
                   "counted, not timed, so that the same seed gives the same file")
        ->check(asv::tools::finite_and_not_negative())
        ->capture_default_str();
    solve.threads = std::max(1U, std::thread::hardware_concurrency());
    app.add_option("--threads", solve.threads, "Threads that race; default: the processors")
        ->check(CLI::Range(1, 1024));
    app.add_option("--stats", arguments.stats, "Write what the run found and spent as JSON");
    app.add_option("--trees", arguments.trees, "Write the search trees as JSON");
    asv::tools::add_reading_options(app, arguments.reading);
    app.add_flag("--reverse", solve.reverse,
                 "Plan from goal to start; the file still leads from start to goal");
    CLI::Option* markdown =
        app.add_flag("--markdown", arguments.markdown, "With --list-planners: as docs/settings.md");
    markdown->needs(app.add_flag_callback(
        "--list-planners",
        [&arguments] {
            if (arguments.markdown)
                asv::tools::list_planners_as_markdown(std::cout);
            else
                asv::tools::list_planners(std::cout);
            throw CLI::Success();
        },
        "List all planners with their settings and exit"));
}

asv::tools::FileRoles roles_of(const Arguments& arguments) {
    asv::tools::FileRoles roles;
    roles.add_input("PROBLEM", arguments.problem);
    roles.add_output("SOLUTION", arguments.solution);
    roles.add_output("--stats", arguments.stats);
    roles.add_output("--trees", arguments.trees);
    return roles;
}

core::Planner chosen_planner(const Arguments& arguments) {
    try {
        core::Planner planner = core::planner_named(arguments.planner);
        for (const std::string& setting : arguments.settings) {
            const std::size_t equals = setting.find('=');
            if (equals == std::string::npos)
                throw std::invalid_argument("--set wants KEY=VALUE, not '" + setting + "'");
            core::set(planner, setting.substr(0, equals), setting.substr(equals + 1));
        }
        return planner;
    } catch (const std::invalid_argument& error) {
        throw asv::tools::UsageError(error.what());
    }
}

std::string progress_text(const core::SolveProgress& progress) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1);
    if (progress.cost)
        text << "cost " << std::setprecision(3) << *progress.cost << std::setprecision(1);
    else
        text << progress.search.iterations << " size: " << progress.search.nodes[0] << ' '
             << progress.search.nodes[1];
    text << "  " << progress.elapsed << " s";
    return text.str();
}

std::size_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void write_trees(const Arguments& arguments, const core::SolveResult& result, std::size_t asvs) {
    io::SearchTrees trees{arguments.planner, asvs, {}, {}};
    for (const core::TreePicture& tree : result.trees)
        trees.trees.push_back({std::string(core::name(tree.root)), tree.points, tree.parents});
    for (const auto& [a, b] : result.edges) trees.edges.push_back({a, b});
    io::write_trees(arguments.trees, trees);
}

void write_stats(const Arguments& arguments, const core::Problem& problem,
                 const core::SolveResult& result) {
    io::RunStatistics run;
    run.problem = std::filesystem::path(arguments.problem).filename().string();
    run.asv_count = problem.asv_count();
    run.obstacle_count = problem.obstacles.size();
    run.planner = arguments.planner;
    run.seed = arguments.solve.seed;
    run.threads = arguments.solve.threads;
    run.status = result.status;
    run.reason = result.reason;
    run.spent = result.statistics;
    run.primitive_steps = result.solution ? result.solution->path.size() - 1 : 0;
    run.peak_memory_bytes = peak_memory();
    run.version = ASV_VERSION;
    io::write_statistics(arguments.stats, run);
}

void report(const Arguments& arguments, const core::SolveResult& result) {
    const core::SolveStatistics& spent = result.statistics;
    std::cerr << std::setprecision(4);
    if (!result.solution) {
        std::cerr << "asv-solve: " << name(result.status) << " after " << spent.time_total
                  << " s (seed " << arguments.solve.seed << "): " << result.reason << '\n';
        return;
    }
    std::cerr << "solved: cost " << spent.cost;
    if (spent.cost_lower_bound > 0)
        std::cerr << ", at most " << spent.cost / spent.cost_lower_bound
                  << " times the least possible";
    std::cerr << ", " << result.solution->path.size() - 1 << " steps";
    if (spent.steps_lower_bound > 0)
        std::cerr << " (any path has " << spent.steps_lower_bound << " or more)";
    std::cerr << ", first path after " << spent.time_to_first << " s, all " << spent.time_total
              << " s, seed " << arguments.solve.seed << '\n';
}

ExitCode exit_code(core::SolveStatus status) {
    switch (status) {
        case core::SolveStatus::solved:
            return ExitCode::done;
        case core::SolveStatus::timeout:
            return ExitCode::no;
        case core::SolveStatus::infeasible:
            return ExitCode::infeasible;
        case core::SolveStatus::interrupted:
            return ExitCode::interrupted;
    }
    return ExitCode::internal;
}

/// Says that the time is up, while the main thread is still busy, and ends the process.
[[noreturn]] void give_up(const Arguments& arguments, bool quiet) {
    core::SolveResult result;
    result.status = core::SolveStatus::timeout;
    result.reason = "time limit, before there was a path";
    result.statistics.time_total = arguments.solve.time_limit;
    ExitCode code = exit_code(result.status);
    try {
        if (!arguments.stats.empty()) write_stats(arguments, {}, result);
        if (!quiet) report(arguments, result);
    } catch (const std::exception& error) {
        std::cerr << "asv-solve: " << error.what() << std::endl;
        code = ExitCode::bad_output;
    }
    std::_Exit(static_cast<int>(code));
}

/// Ends the process at the time limit; a solver that can be stopped has done so before.
std::unique_ptr<TimeLimitWatch> watch_time_limit(const Arguments& arguments, bool quiet) {
    constexpr double never = 1e9;  // seconds; the clock cannot count much longer
    const std::chrono::duration<double> limit(arguments.solve.time_limit);
    if (limit.count() > never) return nullptr;
    const auto moment =
        arguments.started + std::chrono::duration_cast<core::Clock::duration>(limit);
    return std::make_unique<TimeLimitWatch>(moment,
                                            [&arguments, quiet] { give_up(arguments, quiet); });
}

void report_invalid_ends(const std::string& name, const io::ProblemFile& file,
                         const core::InvalidEnds& invalid) {
    for (const core::InvalidEnd& end : invalid.ends())
        std::cerr << io::escaped(name) << ':' << (end.goal ? file.goal_line : file.start_line)
                  << ": " << (end.goal ? "goal" : "start") << " is not valid: " << end.reason
                  << '\n';
}

/// Everything between a problem that has been read and an answer.
ExitCode answer(const CommandLine& command_line, Arguments& arguments, const io::ProblemFile& file,
                std::unique_ptr<TimeLimitWatch> time_limit) {
    for (const std::string* output : {&arguments.solution, &arguments.stats, &arguments.trees})
        if (!output->empty()) io::require_writable(*output);

    try {
        core::require_usable(arguments.solve.planner, file.problem.body_kind());
    } catch (const std::invalid_argument& error) {
        throw asv::tools::UsageError(error.what());
    }

    const asv::tools::InterruptWatch interrupt;
    ProgressLine line(!command_line.quiet());
    arguments.solve.stop = interrupt.token();
    arguments.solve.keep_trees = !arguments.trees.empty();
    if (line.visible())
        arguments.solve.on_progress = [&](const core::SolveProgress& progress) {
            line.show(progress_text(progress));
        };
    arguments.solve.elapsed_before =
        std::chrono::duration<double>(core::Clock::now() - arguments.started).count();
    const core::SolveResult result = core::solve(file.problem, arguments.solve);
    time_limit.reset();
    line.clear();
    if (result.solution) io::write_solution(arguments.solution, *result.solution);
    if (!arguments.trees.empty()) write_trees(arguments, result, file.problem.asv_count());
    if (!arguments.stats.empty()) write_stats(arguments, file.problem, result);
    if (!command_line.quiet()) report(arguments, result);
    return exit_code(result.status);
}

ExitCode solve_file(const CommandLine& command_line, Arguments& arguments) {
    arguments.solve.planner = chosen_planner(arguments);
    asv::tools::FileRoles roles = roles_of(arguments);
    roles.require_distinct();
    auto time_limit = watch_time_limit(arguments, command_line.quiet());
    const io::ProblemFile file = io::read_problem(arguments.problem, arguments.reading);
    command_line.print(file.warnings);
    roles.add_maps(file);
    roles.require_distinct();
    try {
        return answer(command_line, arguments, file, std::move(time_limit));
    } catch (const core::InvalidEnds& invalid) {
        report_invalid_ends(io::input_name(arguments.problem), file, invalid);
        return ExitCode::bad_input;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CommandLine command_line(
        "asv-solve",
        "Plans a motion for a chain of ASVs among obstacles, shortens it, checks it and writes it "
        "as primitive steps.",
        "asv-solve testcases/7ASV.txt 7ASV-solution.txt --seed 7 --stats 7ASV-stats.json");
    Arguments arguments;
    add_options(command_line.options(), arguments);
    return command_line.run(argc, argv, [&] { return solve_file(command_line, arguments); });
}
