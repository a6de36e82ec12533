#include "tools/bench/bench_task.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/benchmark/parameter_curves.hpp"
#include "io/benchmark/record/generated_name.hpp"
#include "io/problem/generation_file.hpp"
#include "tools/bench/problem_arguments.hpp"
#include "tools/bench/records/earlier_runs.hpp"

namespace asv::tools {

namespace {

/// The runs of earlier benchmarks, and what is missing of the planners that are asked for; their
/// problems are read only where something is. False where one cannot be used, which has been told.
bool read_earlier(const CommandLine& command_line, const BenchArguments& arguments,
                  FileRoles& roles, BenchTask& task) {
    task.report = earlier_runs(arguments.from);
    const io::BenchmarkSession& session = task.report.session;
    task.earlier = session.parts.empty() ? std::vector{session} : session.parts;
    const std::vector<std::size_t> planners = add_planners(task.report, arguments.plan.planners);
    task.missing = missing_runs(task.report, planners);
    if (task.missing.empty()) return true;
    if (session.version != ASV_VERSION)
        throw UsageError("the runs of --from are of version " + session.version +
                         ", and do not compare with those of " ASV_VERSION);
    task.report.plan.jobs = std::max(task.report.plan.jobs, arguments.plan.jobs);
    std::vector<core::BenchmarkProblem> problems;
    if (!read_problems(command_line, problem_files(task.report.plan), arguments.reading, roles,
                       problems))
        return false;
    put_in_place(std::move(problems), task.report.plan);
    return true;
}

/// Reads what the problems of files were generated with; the others know it. Throws ReadError,
/// ParseError.
void read_generation(std::vector<core::BenchmarkProblem>& problems, const std::string& name) {
    for (core::BenchmarkProblem& problem : problems)
        if (!core::parameter_of(problem, name) && !io::generator_words(problem.file))
            problem.parameters = io::read_parameters(problem.file + ".json");
}

/// Throws UsageError for a problem without the parameter.
void require_parameter(const io::BenchmarkReport& report) {
    if (report.parameter.empty()) return;
    for (const core::BenchmarkProblem& problem : report.plan.problems)
        if (!core::parameter_of(problem, report.parameter))
            throw UsageError("--parameter " + report.parameter + ": " + problem.name +
                             " has no such number");
}

bool read_task(const CommandLine& command_line, const BenchArguments& arguments, FileRoles& roles,
               BenchTask& task) {
    if (!arguments.from.empty()) return read_earlier(command_line, arguments, roles, task);
    task.report.plan = arguments.plan;
    if (!read_problems(command_line, arguments.problems, arguments.reading, roles,
                       task.report.plan.problems))
        return false;
    if (!arguments.outputs.parameter.empty())
        read_generation(task.report.plan.problems, arguments.outputs.parameter);
    task.missing = core::places(task.report.plan);
    return true;
}

}  // namespace

bool prepare(const CommandLine& command_line, const BenchArguments& arguments, FileRoles& roles,
             BenchTask& task) {
    if (!read_task(command_line, arguments, roles, task)) return false;
    task.report.parameter = arguments.outputs.parameter;
    require_parameter(task.report);
    return true;
}

void resume(const BenchArguments& arguments, BenchTask& task) {
    if (arguments.resume.empty()) return;
    task.report.session.version = ASV_VERSION;
    task.journal.emplace(arguments.resume, task.report);
    task.report.runs = task.journal->runs();
    task.earlier = task.journal->sessions();
    if (!task.earlier.empty()) task.report.session = io::joined(task.earlier);
    task.missing = missing_runs(task.report);
}

}  // namespace asv::tools
