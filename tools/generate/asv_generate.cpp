#include <cstdint>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "core/generate/families.hpp"
#include "io/problem/generation_file.hpp"
#include "io/problem/problem_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/generate/family_commands.hpp"
#include "tools/generate/likeness.hpp"
#include "tools/generate/option_kinds.hpp"
#include "tools/generate/solvability.hpp"

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
    app.add_option("-n,--asvs", chain.asv_count, "Number of ASVs; required")
        ->transform(asv::tools::whole_number(3, 200));
    app.add_option("--seed", arguments.seed, "Seed of all random draws")
        ->transform(asv::tools::whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    app.add_option("-o,--output", arguments.output,
                   "Problem file to write; - for standard output; required")
        ->type_name("FILE.txt");
    asv::tools::add_choice<core::Orientation>(app, "--orientation", chain.orientation,
                                              "Of start and goal",
                                              {{"random", core::Orientation::random},
                                               {"cw", core::Orientation::clockwise},
                                               {"ccw", core::Orientation::counter_clockwise}});
    asv::tools::add_number(app, "--clearance", chain.clearance, {0, 0.1},
                           "Least distance of start and goal to obstacles and bounds");
    asv::tools::add_number(app, "--area-margin", chain.area_margin, {0, 0.2},
                           "How far start and goal are above the minimum area, as a share of it");
    asv::tools::add_number(app, "--least-turn", chain.min_turn, {0, 0.01},
                           "Least turn at every ASV of start and goal, in radians");
    asv::tools::add_number(app, "--least-closing", chain.min_closing_side, {0, 0.05},
                           "Least distance of the first to the last ASV of start and goal");
    app.add_flag(
        "--solvable", arguments.solvable,
        "Check whether a path is certain to exist and write the verdict, solvable or unknown, "
        "with all parameters to OUTPUT.json (nowhere where OUTPUT is -)");
    asv::tools::add_count(app, "--attempts", arguments.attempts, {1, 1'000'000},
                          "With --solvable: draw up to so many problems until one is solvable for "
                          "certain, else keep the last");
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
            if (arguments.solvable) verdict = asv::tools::solvability(problem, arguments.seed);
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

/// The family that was named, if all that was given is understood. Throws UsageError.
const Family& named_family(const CLI::App& app, const std::vector<Family>& families) {
    std::vector<std::string> names;
    const Family* named = nullptr;
    for (const Family& family : families) {
        names.push_back(family.command->get_name());
        if (family.command->parsed()) named = &family;
    }
    const std::vector<std::string> rest = app.remaining(true);
    if (!named) {
        const bool a_word = !rest.empty() && rest.front().front() != '-';
        throw UsageError(
            (a_word ? "'" + rest.front() + "' is no family" : "a family has to be named") +
            "; there are " + asv::tools::listed_by_likeness(names, a_word ? rest.front() : ""));
    }
    if (!rest.empty()) throw UsageError(named->command->get_name() + " takes no " + rest.front());
    for (const char* required : {"--asvs", "--output"})
        if (app.get_option(required)->count() == 0)
            throw UsageError(std::string(required) + " is required");
    return *named;
}

}  // namespace

int main(int argc, char** argv) try {
    CommandLine command_line(
        "asv-generate",
        "Writes a random problem of a family. The same arguments and seed give the same file. "
        "'asv-generate FAMILY --help' lists the family's own options.",
        "asv-generate corridor -n 7 --height-factor 1.1 --seed 3 -o corridor-7.txt");
    Arguments arguments;
    CLI::App& app = command_line.options();
    app.require_subcommand(0, 1)->allow_extras();
    add_common_options(app, arguments);
    const std::vector<Family> families = asv::tools::add_families(app);
    // What is not understood is told in the words of this program: see named_family().
    return command_line.run(argc, argv, [&] {
        return generate(command_line, app, named_family(app, families), arguments);
    });
} catch (...) {
    return asv::tools::report_failed_start("asv-generate");
}
