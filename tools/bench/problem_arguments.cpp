#include "tools/bench/problem_arguments.hpp"

#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <utility>

#include "core/solve/solve.hpp"
#include "io/benchmark/record/generated_name.hpp"
#include "io/problem/generation_file.hpp"
#include "io/problem/problem_digest.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "io/text/parse_error.hpp"
#include "tools/bench/labelled_text.hpp"
#include "tools/families/generator.hpp"

namespace asv::tools {

namespace {

/// True when the problem can be run; tells why where it cannot.
bool accept(const std::string& file, const io::ProblemFile& read) {
    const auto invalid = core::invalid_ends(read.problem);
    for (const core::InvalidEnd& end : invalid)
        std::cerr << io::escaped(io::input_name(file)) << ':'
                  << (end.goal ? read.goal_line : read.start_line) << ": "
                  << (end.goal ? "goal" : "start") << " is not valid: " << end.reason << '\n';
    return invalid.empty();
}

core::BenchmarkProblem generate_problem(const std::string& name, const std::string& file,
                                        const std::vector<std::string>& words) {
    try {
        GeneratedProblem made = generated(words);
        const std::string digest = io::problem_digest(made.problem);
        return {name, file, std::move(made.problem), digest,
                io::number_parameters(made.generation.parameters)};
    } catch (const UsageError& error) {
        throw UsageError((words.empty() ? "generate" : io::escaped(file)) + ": " + error.what());
    }
}

std::vector<ProblemArgument> parse_all(const std::vector<std::string>& given) {
    std::vector<ProblemArgument> arguments;
    std::set<std::string> files;
    for (const std::string& text : given) {
        arguments.push_back(parse_problem_argument(text));
        if (!files.insert(arguments.back().file).second)
            throw UsageError("a problem is given twice: " + io::escaped(arguments.back().file));
    }
    return arguments;
}

}  // namespace

ProblemArgument parse_problem_argument(const std::string& given) {
    const std::size_t begin = begin_of(io::generate_word, given);
    if (begin == std::string::npos) return {"", given};
    const std::string words = tidied(given.substr(begin + io::generate_word.size()));
    std::string label = begin == 0 ? "" : tidied(given.substr(0, given.rfind(':', begin - 1)));
    if (has_control_character(label + words))
        throw UsageError("generate: there is a control character in it");
    return {label.empty() ? words : std::move(label), io::generated_name(words)};
}

void add_problem_roles(const std::vector<std::string>& problems, FileRoles& roles) {
    for (const std::string& given : problems)
        if (const ProblemArgument argument = parse_problem_argument(given); argument.name.empty())
            roles.add_input("PROBLEM", argument.file);
}

std::vector<std::string> problem_names(const std::vector<ProblemArgument>& arguments) {
    std::map<std::string, std::size_t> uses;
    const auto short_name = [](const ProblemArgument& argument) {
        return argument.name.empty() ? std::filesystem::path(argument.file).stem().string()
                                     : argument.name;
    };
    for (const ProblemArgument& argument : arguments) ++uses[short_name(argument)];
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const ProblemArgument& argument : arguments) {
        const std::string name = short_name(argument);
        names.push_back(argument.name.empty() && uses[name] > 1 ? argument.file : name);
        if (!taken.insert(names.back()).second)
            throw UsageError("two problems are called '" + io::escaped(name) +
                             "'; give one a label: \"LABEL: generate: ...\"");
    }
    return names;
}

bool read_problems(const CommandLine& command_line, const std::vector<std::string>& given,
                   const io::ReadOptions& reading, FileRoles& roles,
                   std::vector<core::BenchmarkProblem>& problems) {
    const std::vector<ProblemArgument> arguments = parse_all(given);
    const std::vector<std::string> names = problem_names(arguments);
    bool all_good = true;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& file = arguments[i].file;
        if (const auto words = io::generator_words(file)) {
            problems.push_back(generate_problem(names[i], file, *words));
            continue;
        }
        try {
            io::ProblemFile read = io::read_problem(file, reading);
            command_line.print(read.warnings);
            roles.add_maps(read);
            all_good = accept(file, read) && all_good;
            const std::string digest = io::problem_digest(read.problem);
            problems.push_back({names[i], file, std::move(read.problem), digest});
        } catch (const io::ParseError& error) {
            std::cerr << error.what() << '\n';
            all_good = false;
        } catch (const io::ReadError& error) {
            std::cerr << "asv-bench: " << error.what() << '\n';
            all_good = false;
        }
    }
    return all_good;
}

}  // namespace asv::tools
