#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "core/certificate_check/check_certificate.hpp"
#include "core/validation/trajectory/validate_trajectory.hpp"
#include "core/validation/validate.hpp"
#include "io/certificate/certificate_file.hpp"
#include "io/certificate/verdict_file.hpp"
#include "io/problem/problem_digest.hpp"
#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/solution/trajectory_file.hpp"
#include "io/solution/validation_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/common/motion_limits_options.hpp"
#include "tools/common/number_options.hpp"
#include "tools/common/reading.hpp"

namespace {

using asv::core::Check;
using asv::core::CheckResult;
using asv::core::Offender;
using asv::io::ValidatedPart;
using asv::io::ValidationSummary;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::motion_limits;

constexpr int widest_name = 22;
constexpr int widest_claim = 26;
constexpr const char* trajectory_part = "trajectory";

/// Checks of steps, each of which is told by its end.
bool is_of_steps(Check check) {
    return check == Check::steps || check == Check::times || check == Check::speed;
}

struct Arguments {
    std::string problem;
    std::string solution;
    std::string trajectory;
    std::string certificate;
    std::string json;
    asv::core::MotionLimits limits;  ///< of the trajectory; where an option says nothing, empty
    std::optional<double> tolerance;
    asv::core::ValidationOptions options;  ///< but for the tolerance
    asv::io::ReadOptions reading;
};

asv::tools::FileRoles roles_of(const Arguments& arguments) {
    asv::tools::FileRoles roles;
    roles.add_input("PROBLEM", arguments.problem);
    roles.add_input("SOLUTION", arguments.solution);
    roles.add_input("--trajectory", arguments.trajectory);
    roles.add_input("--certificate", arguments.certificate);
    roles.add_output("--json", arguments.json);
    return roles;
}

void add_options(CLI::App& app, Arguments& arguments) {
    app.add_option("PROBLEM", arguments.problem, "Problem file; - for standard input")
        ->type_name(asv::tools::problem_file)
        ->required();
    app.add_option(
           "SOLUTION", arguments.solution,
           "Solution file, - for standard input; without it the problem's start and goal are "
           "checked")
        ->type_name("FILE.txt");
    app.add_option("--tolerance", arguments.tolerance,
                   "How lenient every requirement is; by default 1e-05, or what a scenario says")
        ->transform(asv::tools::number_from(0));
    app.add_flag("--continuous", arguments.options.continuous,
                 "Also certify the motion between the primitive steps");
    CLI::Option* trajectory =
        app.add_option("--trajectory", arguments.trajectory,
                       "Also check a trajectory of the solution, CSV or JSON: its times, that it "
                       "keeps to the path, speeds and accelerations; - for standard input")
            ->type_name("FILE.csv|.json");
    asv::tools::add_motion_limits(app, arguments.limits, trajectory);
    app.add_option("--certificate", arguments.certificate,
                   "Check a proof of asv-solve that the problem has no path; - for standard input")
        ->type_name("FILE.json");
    app.add_option(
           "--json", arguments.json,
           "Write all results to this file as JSON; - for standard output, and the lines for "
           "people go to standard error")
        ->type_name("FILE.json");
    asv::tools::add_reading_options(app, arguments.reading);
    app.add_flag("--verbose", arguments.options.list_offenders, "List every violation");
}

std::string place(const ValidatedPart& part, Check check, const Offender& offender) {
    const std::optional<std::size_t> line = part.line(check, offender);
    std::string text = line ? "line " + std::to_string(*line) : "";
    const bool numbered = part.name == "path" || part.name == trajectory_part;
    if (numbered && check != Check::cost) {
        const std::string state = "state " + std::to_string(offender.state);
        text = line ? state + ", " + text : state;
    }
    return offender.time ? "on the way to " + text : text;
}

void print(std::ostream& out, const ValidatedPart& part, const CheckResult& result,
           const std::string& prefix) {
    out << std::left << std::setw(widest_name) << prefix + std::string(name(result.check))
        << (result.ok() ? "ok      " : "FAILED  ");
    if (!result.ok()) out << result.failures << " of ";
    const bool of_steps = is_of_steps(result.check) || !prefix.empty();
    if (result.check != Check::cost) {
        out << result.states << (of_steps ? " step" : " state")
            << (result.states == 1 ? ": " : "s: ");
    }
    out << describe(result);
    if (result.worst) out << " (" << place(part, result.check, *result.worst) << ')';
    out << '\n';
    for (const Offender& offender : result.offenders) {
        out << "    " << place(part, result.check, offender) << ": "
            << describe(result.check, offender) << '\n';
    }
}

void print(std::ostream& out, const ValidatedPart& part) {
    if (part.name != "path") out << part.name << '\n';
    for (const CheckResult& result : part.report.checks) print(out, part, result, "");
    for (const CheckResult& result : part.report.motion) print(out, part, result, "motion: ");
}

std::vector<ValidatedPart> check(const CommandLine& command_line, const asv::io::ProblemFile& file,
                                 const Arguments& arguments) {
    const asv::core::Problem& problem = file.problem;
    using asv::core::validate_state;
    asv::core::ValidationOptions options = arguments.options;
    options.tolerance = arguments.tolerance.value_or(problem.requirements.tolerance);
    if (arguments.solution.empty()) {
        return {{"start", file.start_line, validate_state(problem, problem.start, options)},
                {"goal", file.goal_line, validate_state(problem, problem.goal, options)}};
    }
    std::vector<asv::io::Warning> warnings;
    const auto solution =
        asv::io::read_solution(arguments.solution, problem.asv_count(), &warnings);
    command_line.print(warnings);
    std::vector<ValidatedPart> parts = {{"path", 2, validate(problem, solution, options)}};
    if (arguments.trajectory.empty()) return parts;
    const auto [trajectory, first_line] =
        asv::io::read_trajectory(arguments.trajectory, problem.asv_count());
    parts.push_back({trajectory_part, first_line,
                     validate_trajectory(problem.body_kind(), solution.path, trajectory,
                                         motion_limits(arguments.limits, problem), options)});
    return parts;
}

/// Where lines for people go: what is meant for another program stays apart from them.
std::ostream& lines_of(const Arguments& arguments) {
    return arguments.json == asv::io::standard_stream ? std::cerr : std::cout;
}

ExitCode check_certificate(const Arguments& arguments, const asv::core::Problem& problem) {
    const asv::core::CertificateVerdict verdict =
        asv::core::check_certificate(asv::io::read_certificate(arguments.certificate), problem,
                                     asv::io::problem_digest(problem));
    std::ostream& out = lines_of(arguments);
    for (const asv::core::CheckedClaim& claim : verdict.claims)
        out << std::left << std::setw(widest_claim) << claim.claim
            << (claim.holds ? "ok      " : "FAILED  ") << claim.detail << '\n';
    out << (verdict.accepted() ? "accepted: no path exists that the validator accepts\n"
                               : "refused\n");
    std::cout.flush();
    if (!arguments.json.empty())
        asv::io::write_verdict(arguments.json, arguments.problem, arguments.certificate, verdict);
    return verdict.accepted() ? ExitCode::done : ExitCode::no;
}

/// Options that ask for what there is not.
void require_consistent(const Arguments& arguments) {
    if (!arguments.certificate.empty() && !arguments.solution.empty())
        throw asv::tools::UsageError("--certificate goes without a SOLUTION");
    if (!arguments.certificate.empty() && arguments.tolerance)
        throw asv::tools::UsageError("--certificate goes with the problem's own tolerance");
    if (arguments.options.continuous && arguments.solution.empty())
        throw asv::tools::UsageError("--continuous needs a SOLUTION");
    if (!arguments.trajectory.empty() && arguments.solution.empty())
        throw asv::tools::UsageError("--trajectory needs a SOLUTION");
}

ExitCode validate_files(const CommandLine& command_line, const Arguments& arguments) {
    require_consistent(arguments);
    asv::tools::FileRoles roles = roles_of(arguments);
    roles.require_distinct();
    asv::io::ReadOptions reading = arguments.reading;
    reading.tolerance = arguments.tolerance;
    const asv::io::ProblemFile file = asv::io::read_problem(arguments.problem, reading);
    command_line.print(file.warnings);
    roles.add_maps(file);
    roles.require_distinct();
    if (!arguments.certificate.empty()) return check_certificate(arguments, file.problem);
    // Before the path is read and checked, which may take a while.
    if (!arguments.trajectory.empty()) motion_limits(arguments.limits, file.problem);
    const ValidationSummary summary{
        arguments.problem, arguments.solution,
        arguments.tolerance.value_or(file.problem.requirements.tolerance),
        check(command_line, file, arguments)};
    std::ostream& out = lines_of(arguments);
    for (const ValidatedPart& part : summary.parts) print(out, part);
    out << (summary.valid() ? "valid\n" : "not valid\n");
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
