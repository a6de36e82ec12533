#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "core/generate/families.hpp"
#include "core/generate/vouch/vouch.hpp"
#include "io/problem/generation_file.hpp"
#include "io/problem/problem_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/generate/family_commands.hpp"
#include "tools/generate/option_kinds.hpp"

namespace {

namespace core = asv::core;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::Family;
using asv::tools::UsageError;

/// What all families have in common.
struct Arguments {
    core::ChainOptions chain;
    std::uint64_t seed = 1;
    std::string output;
    bool solvable = false;
    std::size_t attempts = 1;
};

void add_common_options(CLI::App& app, Arguments& arguments) {
    core::ChainOptions& chain = arguments.chain;
    app.add_option("-n,--asvs", chain.asv_count, "Number of ASVs, 3 to 200")
        ->check(asv::tools::finite_and_not_negative())
        ->required();
    asv::tools::add_count(app, "--seed", arguments.seed, "Seed of all random draws");
    app.add_option("-o,--output", arguments.output, "Problem file to write; - for standard output")
        ->required();
    asv::tools::add_choice<core::Orientation>(app, "--orientation", chain.orientation,
                                              "Of start and goal",
                                              {{"random", core::Orientation::random},
                                               {"cw", core::Orientation::clockwise},
                                               {"ccw", core::Orientation::counter_clockwise}});
    app.add_option("--clearance", chain.clearance,
                   "Least distance of start and goal to obstacles and bounds")
        ->capture_default_str();
    app.add_option("--area-margin", chain.area_margin,
                   "How far start and goal are above the minimum area, as a share of it")
        ->capture_default_str();
    app.add_option("--least-turn", chain.min_turn,
                   "Least turn at every ASV of start and goal, in radians")
        ->capture_default_str();
    app.add_option("--least-closing", chain.min_closing_side,
                   "Least distance of the first to the last ASV of start and goal")
        ->capture_default_str();
    app.add_flag("--solvable", arguments.solvable,
                 "Check whether a simple path exists and write the verdict, solvable or unknown, "
                 "with all parameters to OUTPUT.json (nowhere where OUTPUT is -)");
    app.add_option("--attempts", arguments.attempts,
                   "With --solvable: draw up to so many problems until one is solvable for "
                   "certain, else keep the last")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
}

/// The options of the family and of the chain with the values that they were given or have anyway.
std::vector<std::pair<std::string, std::string>> parameters(const CLI::App& app,
                                                            const CLI::App& command) {
    std::vector<std::pair<std::string, std::string>> found;
    for (const CLI::App* part : {&command, &app}) {
        for (const CLI::Option* option : part->get_options()) {
            if (option->get_items_expected_max() == 0 || option->get_name() == "--output" ||
                option->get_name() == "--attempts" || option->get_name() == "--seed")
                continue;
            const std::string name = option->get_lnames().front();
            const std::string value =
                option->count() > 0 ? option->results().front() : option->get_default_str();
            found.emplace_back(name, value.empty() ? "default" : value);
        }
    }
    return found;
}

ExitCode generate(const CommandLine& command_line, const CLI::App& app, const Family& family,
                  const Arguments& arguments) {
    const std::string verdict_file =
        arguments.solvable && arguments.output != asv::io::standard_stream
            ? arguments.output + ".json"
            : "";
    asv::tools::FileRoles roles;
    roles.add_output("-o", arguments.output);
    roles.add_output("the verdict of --solvable", verdict_file);
    roles.require_distinct();
    core::Rng rng(arguments.seed);
    core::Problem problem;
    core::Verdict verdict;
    std::size_t attempt = 0;
    try {
        const std::size_t attempts = arguments.solvable ? arguments.attempts : 1;
        while (attempt < attempts && !verdict.solvable) {
            ++attempt;
            problem = family.draw(arguments.chain, rng);
            if (arguments.solvable) verdict = core::vouch(problem);
        }
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    } catch (const core::NoRoom& error) {
        throw UsageError(error.what());
    }
    asv::io::write_problem(arguments.output, problem);
    if (!arguments.solvable) return ExitCode::done;
    if (!verdict_file.empty())
        asv::io::write_generation(
            verdict_file,
            {arguments.output, family.command->get_name(), problem.asv_count(),
             problem.obstacles.size(), arguments.seed, attempt, parameters(app, *family.command),
             verdict.solvable, verdict.reason, ASV_VERSION});
    if (!command_line.quiet())
        std::cerr << asv::io::escaped(asv::io::output_name(arguments.output)) << ": "
                  << (verdict.solvable ? "solvable" : "unknown") << ": " << verdict.reason << '\n';
    return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) {
    CommandLine command_line(
        "asv-generate",
        "Writes a random problem of a family. The same arguments and seed give the same file. "
        "'asv-generate FAMILY --help' lists the family's own options.",
        "asv-generate corridor -n 7 --height-factor 1.1 --seed 3 -o corridor-7.txt");
    Arguments arguments;
    CLI::App& app = command_line.options();
    add_common_options(app, arguments);
    const std::vector<Family> families = asv::tools::add_families(app);
    app.require_subcommand(1);
    return command_line.run(argc, argv, [&] {
        for (const Family& family : families) {
            if (family.command->parsed()) return generate(command_line, app, family, arguments);
        }
        throw UsageError("no family was named");
    });
}
