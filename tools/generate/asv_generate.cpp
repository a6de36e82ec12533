#include <iostream>
#include <optional>
#include <string>
#include <utility>

#include "core/solve/solve.hpp"
#include "io/problem/generation_file.hpp"
#include "io/problem/problem_file.hpp"
#include "io/problem/scenario_text.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/common/reading.hpp"
#include "tools/families/generator.hpp"

namespace {

using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::GeneratedProblem;
using asv::tools::Generator;

struct Arguments {
    std::string output;
    std::string from;  ///< a scenario without a goal; empty: a family
    asv::io::ReadOptions reading{.start_only = true};
};

/// What is to be written, and how it came about; nothing where the start is not valid.
struct Drawn {
    GeneratedProblem made;
    std::string text;
};

std::optional<Drawn> draw_goal(const CommandLine& command_line, const Arguments& arguments,
                               const Generator& generator, asv::tools::FileRoles& roles) {
    asv::io::ProblemFile file = asv::io::read_problem(arguments.from, arguments.reading);
    command_line.print(file.warnings);
    roles.add_maps(file);
    roles.require_distinct();
    // The classic format has a goal, which does not count.
    file.problem.goal = file.problem.start;
    // The goal is the start here, so that the reasons of both are the same.
    if (const auto invalid = asv::core::invalid_ends(file.problem); !invalid.empty()) {
        std::cerr << asv::io::escaped(asv::io::input_name(arguments.from)) << ':' << file.start_line
                  << ": start is not valid: " << invalid.front().reason << '\n';
        return std::nullopt;
    }
    GeneratedProblem made = generator.draw_goal(file.problem);
    std::string text = asv::io::format_scenario(made.problem, file.unit);
    return Drawn{std::move(made), std::move(text)};
}

Drawn draw_problem(const Generator& generator) {
    GeneratedProblem made = generator.draw();
    std::string text = asv::io::format_problem(made.problem);
    return {std::move(made), std::move(text)};
}

ExitCode generate(CommandLine& command_line, const Generator& generator,
                  const Arguments& arguments) {
    const bool from_start = !arguments.from.empty();
    if (from_start)
        generator.require_understood_with_start();
    else
        generator.require_understood();
    if (command_line.options().get_option("--output")->count() == 0)
        throw asv::tools::UsageError("--output is required");
    const std::string& output = arguments.output;
    const std::string verdict_file =
        generator.wants_verdict() && output != asv::io::standard_stream ? output + ".json" : "";
    asv::tools::FileRoles roles;
    roles.add_input("--from", arguments.from);
    roles.add_output("-o", output);
    roles.add_output("the verdict of --solvable", verdict_file);
    roles.require_distinct();
    std::optional<Drawn> drawn =
        from_start ? draw_goal(command_line, arguments, generator, roles) : draw_problem(generator);
    if (!drawn) return ExitCode::bad_input;
    asv::io::Generation& generation = drawn->made.generation;
    generation.problem = output;
    asv::io::write_file(output, drawn->text);
    if (!generator.wants_verdict()) return ExitCode::done;
    if (!verdict_file.empty()) asv::io::write_generation(verdict_file, generation);
    if (!command_line.quiet())
        std::cerr << asv::io::escaped(asv::io::output_name(output)) << ": " << generation.verdict
                  << ": " << generation.reason << '\n';
    return ExitCode::done;
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
    app.add_option("-o,--output", arguments.output,
                   "Problem file to write; - for standard output; required")
        ->type_name("FILE.txt");
    app.add_option(
           "--from", arguments.from,
           "Instead of a problem of a family: the goal for this scenario, which has a start "
           "and none; - for standard input. A scenario is written")
        ->type_name("FILE.json");
    asv::tools::add_reading_options(app, arguments.reading);
    app.get_option("--allow-maps-anywhere")->needs("--from");
    const Generator generator(app);
    return command_line.run(argc, argv,
                            [&] { return generate(command_line, generator, arguments); });
} catch (...) {
    return asv::tools::report_failed_start("asv-generate");
}
