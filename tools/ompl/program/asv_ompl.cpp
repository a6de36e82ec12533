#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <string>

#include <ompl/base/Planner.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "core/bounds/feasibility.hpp"
#include "core/search/rng.hpp"
#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"
#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/ompl/ompl_problem.hpp"
#include "tools/ompl/planner_list.hpp"
#include "tools/ompl/program/ompl_arguments.hpp"

namespace {

namespace adaptor = asv::adaptor;
namespace core = asv::core;
namespace io = asv::io;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::OmplArguments;
using asv::tools::UsageError;
using core::Clock;

/// OMPL takes 32 bits, none of them set being no seed.
void seed_ompl(std::uint64_t seed) {
    constexpr std::size_t seeds = 0xffffffff;
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(1 + core::Rng(seed).below(seeds)));
}

/// When planning has to end, so that the path can still be turned into steps, checked and written;
/// and when the steps have to be there.
struct Deadlines {
    explicit Deadlines(double limit) {
        constexpr double share = 0.1, most = 0.3;  // of the limit; seconds
        constexpr double never = 1e9;              // beyond what a clock can count
        const auto begin = Clock::now();
        const auto after = [&](double seconds) {
            return seconds > never ? Clock::time_point::max()
                                   : begin + std::chrono::duration_cast<Clock::duration>(
                                                 std::chrono::duration<double>(seconds));
        };
        planning = after(limit - std::min(share * limit, most));
        steps = after(limit);
    }
    Clock::time_point planning, steps;
};

ompl::base::PlannerPtr chosen_planner(const OmplArguments& arguments,
                                      const ompl::base::SpaceInformationPtr& information) {
    try {
        const auto planner = adaptor::ompl_planner(arguments.planner, information);
        for (const std::string& setting : arguments.settings) {
            const std::size_t equals = setting.find('=');
            if (equals == std::string::npos)
                throw std::invalid_argument("--set wants PARAMETER=VALUE, not '" + setting + "'");
            adaptor::set_parameter(*planner, setting.substr(0, equals), setting.substr(equals + 1));
        }
        return planner;
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

/// What the validator has against the solution, the motion between its steps included; empty where
/// it is valid.
std::string fault_of(const core::Problem& problem, const core::Solution& solution) {
    const core::ValidationReport report = core::validate(
        problem, solution, {.tolerance = problem.requirements.tolerance, .continuous = true});
    for (const auto* checks : {&report.checks, &report.motion})
        for (const core::CheckResult& check : *checks)
            if (!check.ok()) return std::string(name(check.check)) + ": " + describe(check);
    return {};
}

void say(const CommandLine& command_line, const std::string& text) {
    if (!command_line.quiet()) std::cerr << "asv-ompl: " << text << '\n';
}

/// Checks the solution and writes it.
ExitCode deliver(const CommandLine& command_line, const OmplArguments& arguments,
                 const core::Problem& problem, const core::Solution& solution, bool certified) {
    const std::string fault = fault_of(problem, solution);
    if (!fault.empty() && arguments.motion == "certified")
        throw std::logic_error("the path found fails the check of " + fault);
    io::write_solution(arguments.solution, solution);
    if (!fault.empty()) {
        // Whether quiet or not: nobody shall take it for a solution.
        std::cerr << "asv-ompl: not valid: " << fault << '\n';
        return ExitCode::no;
    }
    say(command_line, "solved: cost " + std::to_string(solution.cost) + ", " +
                          std::to_string(solution.path.size() - 1) + " steps" +
                          (certified ? "" : "; not all of its motions can be proven"));
    return ExitCode::done;
}

ExitCode plan(const CommandLine& command_line, const OmplArguments& arguments,
              const core::Problem& problem, const Deadlines& deadlines) {
    const auto motions = arguments.motion == "certified" ? adaptor::MotionCheck::certified
                                                         : adaptor::MotionCheck::sampled;
    const adaptor::OmplProblem adapted(problem, motions);
    const auto definition = adapted.definition(arguments.anytime ? adaptor::Goodness::best_path
                                                                 : adaptor::Goodness::any_path);
    const auto planner = chosen_planner(arguments, adapted.space_information());
    planner->setProblemDefinition(definition);
    planner->setup();
    const ompl::base::PlannerStatus status = planner->solve(ompl::base::PlannerTerminationCondition(
        [&] { return Clock::now() >= deadlines.planning; }));
    const auto* path =
        dynamic_cast<const ompl::geometric::PathGeometric*>(definition->getSolutionPath().get());
    if (!definition->hasExactSolution() || !path) {
        say(command_line, "no path found: " + status.asString());
        return ExitCode::no;
    }
    const std::optional<core::Solution> solution = adapted.solution(*path, deadlines.steps);
    if (!solution) {
        say(command_line, "the time is up before the path is turned into primitive steps");
        return ExitCode::no;
    }
    return deliver(command_line, arguments, problem, *solution, adapted.certified(*path));
}

/// The proofs that come before any planner; empty where there is none.
std::string proof_of_infeasibility(const core::Problem& problem) {
    if (const auto proof = core::check_area(problem); proof.proven_infeasible())
        return proof.reason;
    if (!core::invalid_ends(problem).empty()) return {};
    return core::check_orientation(problem).reason;
}

ExitCode plan_file(const CommandLine& command_line, OmplArguments& arguments) {
    const Deadlines deadlines(arguments.time_limit);
    seed_ompl(arguments.seed);
    chosen_planner(arguments, adaptor::information_of_a_plane());  // is there such a one?
    if (arguments.check_planner) return ExitCode::done;
    if (arguments.problem.empty() || arguments.solution.empty())
        throw UsageError("PROBLEM and SOLUTION are required\nRun with --help for help.");
    asv::tools::FileRoles roles;
    roles.add_input("PROBLEM", arguments.problem);
    roles.add_output("SOLUTION", arguments.solution);
    roles.require_distinct();
    const io::ProblemFile file = io::read_problem(arguments.problem, arguments.reading);
    command_line.print(file.warnings);
    roles.add_maps(file);
    roles.require_distinct();
    io::require_writable(arguments.solution);
    if (const std::string reason = proof_of_infeasibility(file.problem); !reason.empty()) {
        say(command_line, "infeasible: " + reason);
        return ExitCode::infeasible;
    }
    try {
        return plan(command_line, arguments, file.problem, deadlines);
    } catch (const core::InvalidEnds& invalid) {
        std::cerr << io::escaped(arguments.problem) << ": " << invalid.what() << '\n';
        return ExitCode::bad_input;
    }
}

}  // namespace

int main(int argc, char** argv) try {
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    CommandLine command_line(
        "asv-ompl",
        "Plans with a planner of OMPL, the Open Motion Planning Library, whose motions are proven "
        "valid as the library's own are, and writes the path as primitive steps, once checked.",
        "asv-ompl testcases/3ASV.txt 3ASV-solution.txt --planner BITstar --set use_k_nearest=0");
    OmplArguments arguments;
    add_options(command_line.options(), arguments);
    return command_line.run(argc, argv, [&] { return plan_file(command_line, arguments); });
} catch (...) {
    return asv::tools::report_failed_start("asv-ompl");
}
