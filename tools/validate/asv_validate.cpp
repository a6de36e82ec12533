#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "core/validation/validate.hpp"
#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/solution/validation_file.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/number_options.hpp"

namespace {

using asv::core::Check;
using asv::core::CheckResult;
using asv::core::Offender;
using asv::io::ValidatedPart;
using asv::io::ValidationSummary;
using asv::tools::CommandLine;
using asv::tools::ExitCode;

constexpr int widest_name = 22;

struct Arguments {
    std::string problem;
    std::string solution;
    std::string json;
    asv::core::ValidationOptions options;
};

void add_options(CLI::App& app, Arguments& arguments) {
    app.add_option("PROBLEM", arguments.problem, "Problem file")
        ->type_name(asv::tools::problem_file)
        ->required();
    app.add_option("SOLUTION", arguments.solution,
                   "Solution file; without it the problem's start and goal are checked")
        ->type_name("FILE.txt");
    app.add_option("--tolerance", arguments.options.tolerance, "How lenient every requirement is")
        ->transform(asv::tools::number_from(0))
        ->capture_default_str();
    app.add_flag("--continuous", arguments.options.continuous,
                 "Also certify the motion between the primitive steps");
    app.add_option("--json", arguments.json, "Write all results to this file as JSON")
        ->type_name("FILE.json");
    app.add_flag("--verbose", arguments.options.list_offenders, "List every violation");
}

std::string place(const ValidatedPart& part, Check check, const Offender& offender) {
    std::string text = "line " + std::to_string(part.line(check, offender));
    if (part.name == "path" && check != Check::cost) {
        text = "state " + std::to_string(offender.state) + ", " + text;
    }
    return offender.time ? "on the way to " + text : text;
}

void print(const ValidatedPart& part, const CheckResult& result, const std::string& prefix) {
    std::cout << std::left << std::setw(widest_name) << prefix + std::string(name(result.check))
              << (result.ok() ? "ok      " : "FAILED  ");
    if (!result.ok()) std::cout << result.failures << " of ";
    const bool of_steps = result.check == Check::steps || !prefix.empty();
    if (result.check != Check::cost) {
        std::cout << result.states << (of_steps ? " step" : " state")
                  << (result.states == 1 ? ": " : "s: ");
    }
    std::cout << describe(result);
    if (result.worst) std::cout << " (" << place(part, result.check, *result.worst) << ')';
    std::cout << '\n';
    for (const Offender& offender : result.offenders) {
        std::cout << "    " << place(part, result.check, offender) << ": "
                  << describe(result.check, offender) << '\n';
    }
}

void print(const ValidatedPart& part) {
    if (part.name != "path") std::cout << part.name << '\n';
    for (const CheckResult& result : part.report.checks) print(part, result, "");
    for (const CheckResult& result : part.report.motion) print(part, result, "motion: ");
}

std::vector<ValidatedPart> check(const asv::io::ProblemFile& file, const Arguments& arguments) {
    const asv::core::Problem& problem = file.problem;
    using asv::core::validate_state;
    const auto& options = arguments.options;
    if (arguments.solution.empty()) {
        return {{"start", file.start_line, validate_state(problem, problem.start, options)},
                {"goal", file.goal_line, validate_state(problem, problem.goal, options)}};
    }
    const auto solution = asv::io::read_solution(arguments.solution, problem.asv_count());
    return {{"path", 2, validate(problem, solution, options)}};
}

ExitCode validate_files(const CommandLine& command_line, const Arguments& arguments) {
    if (arguments.options.continuous && arguments.solution.empty()) {
        throw asv::tools::UsageError("--continuous needs a SOLUTION");
    }
    const asv::io::ProblemFile file = asv::io::read_problem(arguments.problem);
    command_line.print(file.warnings);
    const ValidationSummary summary{arguments.problem, arguments.solution,
                                    arguments.options.tolerance, check(file, arguments)};
    for (const ValidatedPart& part : summary.parts) print(part);
    std::cout << (summary.valid() ? "valid\n" : "not valid\n");
    // The JSON may be told to follow on standard output.
    std::cout.flush();
    if (!arguments.json.empty()) write_validation(arguments.json, summary);
    return summary.valid() ? ExitCode::done : ExitCode::no;
}

}  // namespace

int main(int argc, char** argv) try {
    CommandLine command_line("asv-validate",
                             "Checks every requirement on a solution, one line each, or on the "
                             "start and the goal of a problem.",
                             "asv-validate testcases/7ASV.txt 7ASV-solution.txt --continuous");
    Arguments arguments;
    add_options(command_line.options(), arguments);
    return command_line.run(argc, argv, [&] { return validate_files(command_line, arguments); });
} catch (...) {
    return asv::tools::report_failed_start("asv-validate");
}
