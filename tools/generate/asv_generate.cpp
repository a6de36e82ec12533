#include <iostream>
#include <string>

#include "io/problem/generation_file.hpp"
#include "io/problem/problem_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/families/generator.hpp"

namespace {

using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::Generator;

ExitCode generate(CommandLine& command_line, const Generator& generator,
                  const std::string& output) {
    generator.require_understood();
    if (command_line.options().get_option("--output")->count() == 0)
        throw asv::tools::UsageError("--output is required");
    const std::string verdict_file =
        generator.wants_verdict() && output != asv::io::standard_stream ? output + ".json" : "";
    asv::tools::FileRoles roles;
    roles.add_output("-o", output);
    roles.add_output("the verdict of --solvable", verdict_file);
    roles.require_distinct();
    asv::tools::GeneratedProblem made = generator.draw();
    asv::io::Generation& generation = made.generation;
    generation.problem = output;
    asv::io::write_problem(output, made.problem);
    if (!generator.wants_verdict()) return ExitCode::done;
    if (!verdict_file.empty()) asv::io::write_generation(verdict_file, generation);
    if (!command_line.quiet())
        std::cerr << asv::io::escaped(asv::io::output_name(output)) << ": "
                  << (generation.solvable ? "solvable" : "unknown") << ": " << generation.reason
                  << '\n';
    return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) try {
    CommandLine command_line(
        "asv-generate",
        "Writes a random problem of a family. The same arguments and seed give the same file. "
        "'asv-generate FAMILY --help' lists the family's own options.",
        "asv-generate corridor -n 7 --height-factor 1.1 --seed 3 -o corridor-7.txt");
    std::string output;
    CLI::App& app = command_line.options();
    app.add_option("-o,--output", output, "Problem file to write; - for standard output; required")
        ->type_name("FILE.txt");
    const Generator generator(app);
    return command_line.run(argc, argv, [&] { return generate(command_line, generator, output); });
} catch (...) {
    return asv::tools::report_failed_start("asv-generate");
}
