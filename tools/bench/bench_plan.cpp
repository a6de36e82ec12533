#include "tools/bench/bench_plan.hpp"

#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>

#include "core/solve/idle_settings.hpp"
#include "io/benchmark/ompl_log.hpp"
#include "io/benchmark/record/command_words.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "tools/bench/labelled_text.hpp"
#include "tools/bench/ompl_planner.hpp"
#include "tools/bench/runs/supervised_process.hpp"

namespace asv::tools {

namespace {

/// Sets one KEY=VALUE of the planner and remembers it.
void set_one(core::BenchmarkPlanner& planner, const std::string& setting) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
        throw UsageError("--planner wants [LABEL:] NAME [KEY=VALUE]..., not '" + setting + "'");
    const std::string key = setting.substr(0, equals), value = setting.substr(equals + 1);
    core::set(planner.planner, key, value);
    planner.settings.emplace_back(key, value);
}

constexpr std::string_view exec_word = "exec ";

/// Throws std::invalid_argument unless the command can be run and come to something.
void require_runnable(const std::vector<std::string>& command) {
    // What is filled in is told by what it is filled with.
    const std::string problem(1, '\1'), solution(1, '\2');
    std::string all;
    for (const std::string& word : command) all += io::fill_in(word, {problem, solution, "", ""});
    if (all.find(problem) == std::string::npos)
        throw std::invalid_argument("{problem} does not stand in it");
    if (all.find(solution) == std::string::npos)
        throw std::invalid_argument("{solution} does not stand in it");
    if (!is_program(command[0]))
        throw std::invalid_argument("there is no program '" + command[0] + "' that can be run");
}

core::BenchmarkPlanner parse_external(const std::string& text, std::size_t exec) {
    core::BenchmarkPlanner planner;
    try {
        planner.command = io::split_command(text.substr(exec + exec_word.size()));
        if (planner.command.empty()) throw std::invalid_argument("there is no command");
        require_runnable(planner.command);
    } catch (const std::invalid_argument& error) {
        throw UsageError("--planner " + text + ": " + error.what());
    }
    const std::size_t colon = exec == 0 ? std::string::npos : text.rfind(':', exec - 1);
    planner.label =
        colon == std::string::npos ? io::planner_text(planner) : tidied(text.substr(0, colon));
    if (planner.label.empty()) planner.label = io::planner_text(planner);
    return planner;
}

}  // namespace

core::BenchmarkPlanner parse_planner(const std::string& given) {
    const std::string text = tidied(given);
    if (has_control_character(text))
        throw UsageError("--planner: there is a control character in it");
    if (const std::size_t exec = begin_of(exec_word, given); exec != std::string::npos)
        return parse_external(given, exec);
    if (const std::size_t ompl = begin_of(ompl_prefix, text); ompl != std::string::npos)
        return parse_ompl_planner(text, ompl);
    const std::size_t colon = text.rfind(':');
    const std::string call = colon == std::string::npos ? text : text.substr(colon + 1);
    core::BenchmarkPlanner planner;
    planner.label = tidied(text.substr(0, colon));
    std::istringstream words(call);
    std::string word;
    words >> word;
    try {
        planner.planner = core::planner_named(word);
        while (words >> word) set_one(planner, word);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    if (planner.label.empty()) planner.label = tidied(call);
    return planner;
}

std::vector<core::BenchmarkPlanner> parse_planners(const std::vector<std::string>& texts) {
    std::vector<core::BenchmarkPlanner> planners;
    for (const std::string& text : texts) {
        if (text == "all")
            for (const std::string_view name : core::planner_names())
                planners.push_back(parse_planner(std::string(name)));
        else
            planners.push_back(parse_planner(text));
    }
    std::set<std::string> labels;
    for (const core::BenchmarkPlanner& planner : planners)
        if (!labels.insert(planner.label).second)
            throw UsageError("two planners are called '" + planner.label +
                             "'; give one a label: \"LABEL: NAME KEY=VALUE\"");
    return planners;
}

std::vector<std::filesystem::path> log_files(const core::BenchmarkPlan& plan,
                                             const std::string& name) {
    std::vector<std::filesystem::path> files;
    if (name.empty()) return files;
    io::BenchmarkReport outline;
    outline.plan = plan;
    for (const core::RunPlace& place : core::places(plan)) {
        outline.runs.emplace_back();
        outline.runs.back().place = place;
    }
    const bool several = plan.problems.size() * plan.directions.size() > 1;
    if (several && name == io::standard_stream)
        throw UsageError("--ompl-log - holds one problem in one direction, not several");
    for (const io::Experiment& experiment : io::experiments(outline))
        files.push_back(io::ompl_log_file(name, experiment, several));
    return files;
}

void require_usable(const core::BenchmarkPlan& plan) {
    for (const core::BenchmarkProblem& problem : plan.problems)
        for (const core::BenchmarkPlanner& planner : plan.planners) try {
                if (planner.external()) continue;
                core::require_usable(planner.planner, problem.problem.body_kind());
            } catch (const std::invalid_argument& error) {
                throw UsageError(problem.name + ", " + planner.label + ": " + error.what());
            }
}

void warn_of_idle_settings(const CommandLine& command_line, const core::BenchmarkPlan& plan) {
    if (command_line.quiet()) return;
    for (const core::BenchmarkProblem& problem : plan.problems)
        for (const core::BenchmarkPlanner& planner : plan.planners)
            for (const auto& [key, value] : planner.settings) {
                const std::string why =
                    core::why_without_effect(planner.planner, key, problem.problem.body_kind());
                if (!why.empty())
                    std::cerr << "asv-bench: warning: " << planner.label << " on " << problem.name
                              << ": " << key << "=" << value << " has no effect: " << why << '\n';
            }
}

}  // namespace asv::tools
