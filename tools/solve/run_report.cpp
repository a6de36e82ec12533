#include "tools/solve/run_report.hpp"

#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include <sys/resource.h>

#include "core/bounds/certify/certify.hpp"
#include "core/solve/idle_settings.hpp"
#include "core/trajectory/time_optimal.hpp"
#include "core/validation/trajectory/validate_trajectory.hpp"
#include "io/certificate/certificate_file.hpp"
#include "io/problem/problem_digest.hpp"
#include "io/solution/statistics_file.hpp"
#include "io/solution/trajectory_file.hpp"
#include "io/solution/trees_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/common/interrupt.hpp"

namespace asv::tools {

namespace {

using core::SolveStatus;

/// For the last words of a run that is cut off: where somebody must read them, and where not.
constexpr std::chrono::milliseconds time_for_readers{8}, time_for_files{500};

std::size_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::string seconds(double time) {
    std::ostringstream text;
    text << std::setprecision(3) << time << " s";
    return text.str();
}

/// What kept the run from an answer.
std::string reason_for(const SolveArguments& arguments, const CutOff& at) {
    const std::string cause = at.interrupted ? "interrupted" : "time limit";
    if (at.stage == Stage::reading) return cause + ", while the problem was read";
    if (!at.path_after) return cause + ", before there was a path";
    const std::string found = "a path was found after " + seconds(*at.path_after);
    if (at.stage == Stage::writing_solution)
        return cause + ", while " + arguments.solution + " was written" +
               (at.to_stream ? ", which nobody reads; " : "; ") + found;
    return cause + ", before the path was checked and written; " + found;
}

ExitCode code_for(const CutOff& at, SolveStatus status) {
    if (at.stage > Stage::writing_solution)
        return at.to_stream && !at.interrupted ? ExitCode::bad_output : exit_code(status);
    if (at.interrupted) return ExitCode::interrupted;
    return at.to_stream ? ExitCode::bad_output : ExitCode::no;
}

/// What was left out of a run that has its answer.
std::string left_out(const SolveArguments& arguments, const CutOff& at) {
    struct Output {
        Stage stage;
        std::string option;
        const std::string& file;
    };
    const Output outputs[] = {
        {Stage::writing_statistics, "--stats ", arguments.stats},
        {Stage::writing_certificate, "--certificate ", arguments.certificate},
        {Stage::writing_trajectory, "--trajectory ", arguments.trajectory},
        {Stage::writing_trees, "--trees ", arguments.trees},
    };
    std::string text = at.interrupted ? "interrupted" : "time limit";
    for (const Output& output : outputs) {
        if (output.stage < at.stage || output.file.empty()) continue;
        const bool unread = output.stage == at.stage && at.to_stream;
        text += "; " + output.option + output.file +
                (unread ? " was not read to its end" : " is left out");
    }
    return text;
}

}  // namespace

ExitCode exit_code(SolveStatus status) {
    switch (status) {
        case SolveStatus::solved:
            return ExitCode::done;
        case SolveStatus::timeout:
            return ExitCode::no;
        case SolveStatus::infeasible:
            return ExitCode::infeasible;
        case SolveStatus::interrupted:
            return ExitCode::interrupted;
    }
    return ExitCode::internal;
}

double write_trajectory(const SolveArguments& arguments, const core::Problem& problem,
                        const core::SolveResult& result) {
    const core::Path& path = result.solution->path;
    const core::Trajectory trajectory = core::time_optimal(path, arguments.limits);
    const core::ValidationReport checked =
        core::validate_trajectory(problem.body_kind(), path, trajectory, arguments.limits,
                                  {.tolerance = problem.requirements.tolerance});
    for (const core::CheckResult& check : checked.checks)
        if (!check.ok())
            throw std::logic_error("the trajectory fails the check of " +
                                   std::string(core::name(check.check)) + ": " +
                                   core::describe(check));
    io::write_trajectory(arguments.trajectory, trajectory,
                         io::trajectory_format(arguments.trajectory).value());
    return trajectory.duration();
}

void write_certificate(const SolveArguments& arguments, const core::Problem& problem,
                       SolveStatus status) {
    const char* why = "the problem is not proven to have no path";
    if (status == SolveStatus::solved) why = "the problem is solved";
    if (status == SolveStatus::infeasible) {
        if (const auto proof = core::certify_infeasibility(problem)) {
            io::write_certificate(arguments.certificate,
                                  {core::certified(problem, io::problem_digest(problem)), *proof});
            return;
        }
        why = "a proof of this kind has none";
    }
    if (!arguments.quiet)
        std::cerr << "asv-solve: --certificate " << io::escaped(arguments.certificate)
                  << " is not written: " << why << '\n';
}

void write_trees(const SolveArguments& arguments, const core::SolveResult& result,
                 std::size_t asv_count) {
    io::SearchTrees trees{arguments.planner, asv_count, {}, {}};
    for (const core::TreePicture& tree : result.trees)
        trees.trees.push_back({std::string(core::name(tree.root)), tree.points, tree.parents});
    for (const auto& [a, b] : result.edges) trees.edges.push_back({a, b});
    io::write_trees(arguments.trees, trees);
}

void write_statistics(const SolveArguments& arguments, const core::Problem& problem,
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

void report(const SolveArguments& arguments, const core::SolveResult& result,
            std::optional<double> duration) {
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
    if (spent.optimal) std::cerr << " (nothing left to gain)";
    std::cerr << ", " << result.solution->path.size() - 1 << " steps";
    if (spent.steps_lower_bound > 0)
        std::cerr << " (any path has " << spent.steps_lower_bound << " or more)";
    std::cerr << ", first path after " << spent.time_to_first << " s, all " << spent.time_total
              << " s, seed " << arguments.solve.seed << '\n';
    if (duration) std::cerr << "trajectory: " << *duration << " s\n";
}

std::string text_of(const core::InvalidEnd& end) {
    return (end.goal ? "goal is not valid: " : "start is not valid: ") + end.reason;
}

void report_invalid_ends(const SolveArguments& arguments, const io::ProblemFile& file,
                         const core::InvalidEnds& invalid) {
    const std::string name = io::escaped(io::input_name(arguments.problem));
    for (const core::InvalidEnd& end : invalid.ends())
        std::cerr << name << ':' << (end.goal ? file.goal_line : file.start_line) << ": "
                  << text_of(end) << '\n';
}

void warn_of_idle_settings(const SolveArguments& arguments, const core::Problem& problem) {
    if (arguments.quiet) return;
    for (const std::string& setting : arguments.settings) {
        const std::string name = setting.substr(0, setting.find('='));
        const std::string why =
            core::why_without_effect(arguments.solve.planner, name, problem.body_kind());
        if (!why.empty())
            std::cerr << "asv-solve: warning: --set " << setting << " has no effect: " << why
                      << '\n';
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

int give_up(const SolveArguments& arguments, const CutOff& at, SolveStatus status) {
    int code = static_cast<int>(code_for(at, status));
    end_anyway_after(time_for_readers, code);
    if (at.stage > Stage::writing_solution) {
        std::cerr << "asv-solve: " << left_out(arguments, at) << std::endl;
        return code;
    }
    core::SolveResult result;
    result.status = at.interrupted ? SolveStatus::interrupted : SolveStatus::timeout;
    result.reason = reason_for(arguments, at);
    result.statistics.time_total =
        std::chrono::duration<double>(core::Clock::now() - arguments.started).count();
    std::string failure;
    if (!arguments.stats.empty()) try {
            if (!is_stream(arguments.stats)) end_anyway_after(time_for_files, code);
            write_statistics(arguments, {}, result);
        } catch (const std::exception& error) {
            failure = error.what();
            code = static_cast<int>(ExitCode::bad_output);
        }
    end_anyway_after(time_for_readers, code);
    if (!failure.empty()) std::cerr << "asv-solve: " << failure << std::endl;
    if (!arguments.quiet) report(arguments, result);
    for (const auto& [option, file] :
         {std::pair("--certificate", &arguments.certificate),
          std::pair("--trajectory", &arguments.trajectory), std::pair("--trees", &arguments.trees)})
        if (!arguments.quiet && !file->empty())
            std::cerr << "asv-solve: " << option << ' ' << *file << " is left out" << std::endl;
    return code;
}

}  // namespace asv::tools
