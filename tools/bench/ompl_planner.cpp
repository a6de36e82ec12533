#include "tools/bench/ompl_planner.hpp"

#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/bench/runs/supervised_process.hpp"
#include "tools/common/command_line.hpp"

namespace asv::tools {

namespace {

using Words = std::vector<std::string>;

std::string program_of_ompl() {
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe");
    return (own.parent_path() / "asv-ompl").string();
}

/// The arguments of asv-ompl that choose the planner.
Words arguments_for(std::string_view call) {
    std::istringstream words{std::string(call)};
    Words arguments{"--planner", ""};
    words >> arguments.back();
    for (std::string word; words >> word;) {
        if (!word.starts_with("--")) arguments.emplace_back("--set");
        arguments.push_back(word);
    }
    return arguments;
}

/// Has the program look at the arguments; false where it does not take them, and has said why.
bool takes(const std::string& program, Words arguments) {
    arguments.insert(arguments.begin(), program);
    arguments.emplace_back("--check-planner");
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    pid_t child = 0;
    int status = 0;
    if (::posix_spawn(&child, program.c_str(), nullptr, nullptr, pointers.data(), environ) != 0)
        return false;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// The word as a command's placeholders leave it: { and } twice.
std::string literal(const std::string& word) {
    std::string result;
    for (const char c : word) result.append(c == '{' || c == '}' ? 2 : 1, c);
    return result;
}

}  // namespace

core::BenchmarkPlanner parse_ompl_planner(const std::string& text, std::size_t begin) {
    const std::string program = program_of_ompl();
    if (!is_program(program))
        throw UsageError("--planner " + text +
                         ": this asv-bench was built without OMPL: there is no " + program +
                         " (docs/ompl.md)");
    const Words arguments = arguments_for(text.substr(begin + std::string(ompl_prefix).size()));
    if (!takes(program, arguments))
        throw UsageError("--planner " + text + ": asv-ompl does not take it");
    core::BenchmarkPlanner planner;
    planner.label = begin == 0 ? text : text.substr(0, text.rfind(':', begin - 1));
    planner.command = {literal(program), "{problem}", "{solution}"};
    for (const std::string& argument : arguments) planner.command.push_back(literal(argument));
    for (const char* word : {"--seed", "{seed}", "--time-limit", "{time}", "--quiet"})
        planner.command.emplace_back(word);
    return planner;
}

}  // namespace asv::tools
