#include "io/benchmark/experiment.hpp"

#include <algorithm>

#include "core/benchmark/summary.hpp"

namespace asv::io {

namespace {

using core::BenchmarkRun;

/// Those of OMPL, then what only we tell.
constexpr std::array<std::string_view, 13> words_of_status{
    "Unknown status",  "Invalid start",        "Invalid goal",   "Unrecognized goal type",
    "Timeout",         "Approximate solution", "Exact solution", "Crash",
    "Abort",           "Infeasible",           "No path",        "Memory limit",
    "Invalid solution"};

std::int64_t status_value(const BenchmarkRun& run) {
    switch (run.status) {
        case core::RunStatus::timeout:
            return 4;
        case core::RunStatus::solved:
            return 6;
        case core::RunStatus::crash:
            return 7;
        case core::RunStatus::interrupted:
            return 8;
        case core::RunStatus::infeasible:
            return 9;
        case core::RunStatus::no_path:
            return 10;
        case core::RunStatus::memory_limit:
            return 11;
        case core::RunStatus::invalid:
            return 12;
    }
    return 0;
}

AttributeValue if_solved(const BenchmarkRun& run, AttributeValue value) {
    return run.solved() ? value : AttributeValue{};
}

AttributeValue count(std::uint64_t value) {
    return static_cast<std::int64_t>(value);
}

/// Until the first path, or until the planner gave up: what comes after it is simplification.
double planning_time(const BenchmarkRun& run) {
    return run.solved() ? run.spent.time_to_first : run.spent.time_total;
}

using Report = BenchmarkReport;
using Run = BenchmarkRun;
using Value = AttributeValue;

constexpr double megabyte = 1024 * 1024;

constexpr std::array<Attribute, 20> attributes{{
    {"time", "REAL", [](const Report&, const Run& run) -> Value { return planning_time(run); }},
    {"memory", "REAL",
     [](const Report&, const Run& run) -> Value {
         if (!run.peak_memory_bytes) return {};
         return static_cast<double>(*run.peak_memory_bytes) / megabyte;
     }},
    {"status", "ENUM", [](const Report&, const Run& run) -> Value { return status_value(run); }},
    {"solved", "BOOLEAN",
     [](const Report&, const Run& run) -> Value { return count(run.solved()); }},
    {"approximate solution", "BOOLEAN",
     [](const Report&, const Run&) -> Value { return count(0); }},
    {"correct solution", "BOOLEAN",
     [](const Report&, const Run& run) -> Value { return if_solved(run, count(1)); }},
    {"solution length", "REAL",
     [](const Report&, const Run& run) -> Value { return if_solved(run, run.spent.cost_first); }},
    {"simplification time", "REAL",
     [](const Report&, const Run& run) -> Value {
         return if_solved(run, run.spent.time_total - run.spent.time_to_first);
     }},
    {"simplified solution length", "REAL",
     [](const Report&, const Run& run) -> Value { return if_solved(run, run.spent.cost); }},
    {"simplified correct solution", "BOOLEAN",
     [](const Report&, const Run& run) -> Value { return if_solved(run, count(1)); }},
    {"simplified solution segments", "INTEGER",
     [](const Report&, const Run& run) -> Value {
         return if_solved(run, count(run.primitive_steps));
     }},
    {"graph states", "INTEGER",
     [](const Report&, const Run& run) -> Value { return count(core::node_count(run)); }},
    {"iterations", "INTEGER",
     [](const Report&, const Run& run) -> Value { return count(run.spent.iterations); }},
    {"state checks", "INTEGER",
     [](const Report&, const Run& run) -> Value { return count(run.spent.state_checks); }},
    {"edge checks", "INTEGER",
     [](const Report&, const Run& run) -> Value { return count(run.spent.edge_checks); }},
    {"cost lower bound", "REAL",
     [](const Report&, const Run& run) -> Value {
         return run.spent.cost_lower_bound > 0 ? Value{run.spent.cost_lower_bound} : Value{};
     }},
    {"cost ratio", "REAL",
     [](const Report&, const Run& run) -> Value {
         const auto ratio = core::cost_ratio(run);
         return ratio ? Value{*ratio} : Value{};
     }},
    {"time in units", "REAL",
     [](const Report& report, const Run& run) -> Value {
         return planning_time(run) / report.session.unit();
     }},
    {"total time", "REAL",
     [](const Report&, const Run& run) -> Value { return run.spent.time_total; }},
    {"seed", "INTEGER",
     [](const Report&, const Run& run) -> Value { return count(run.place.seed); }},
}};

}  // namespace

std::string without_blanks(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
    return text;
}

std::vector<Experiment> experiments(const BenchmarkReport& report) {
    std::vector<Experiment> result;
    for (const BenchmarkRun& run : report.runs) {
        const auto& [problem, planner, direction, seed] = run.place;
        if (!result.empty() && result.back().problem == problem &&
            result.back().direction == direction)
            continue;
        const bool reversed = direction == core::Direction::reversed;
        result.push_back(
            {without_blanks(report.plan.problems[problem].name) + (reversed ? "-reversed" : ""),
             problem, direction});
    }
    return result;
}

std::vector<const BenchmarkRun*> runs_of(const BenchmarkReport& report,
                                         const Experiment& experiment, std::size_t planner) {
    std::vector<const BenchmarkRun*> result;
    for (const BenchmarkRun& run : report.runs)
        if (run.place.problem == experiment.problem &&
            run.place.direction == experiment.direction && run.place.planner == planner)
            result.push_back(&run);
    return result;
}

std::span<const Attribute> run_attributes() {
    return attributes;
}

std::string column_name(std::string_view attribute) {
    std::string name{attribute};
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

std::span<const std::string_view> status_words() {
    return words_of_status;
}

std::string setup_text(const BenchmarkReport& report, const Experiment& experiment) {
    const core::BenchmarkPlan& plan = report.plan;
    const core::BenchmarkProblem& problem = plan.problems[experiment.problem];
    return "Problem: " + problem.file + "\nASVs: " + std::to_string(problem.problem.asv_count()) +
           "\nObstacles: " + std::to_string(problem.problem.obstacles.size()) +
           "\nDirection: " + std::string(core::name(experiment.direction)) +
           "\nSeconds of improvement after the first path: " + short_number(plan.optimize) +
           "\nThreads of a run: " + std::to_string(plan.threads) +
           "\nRuns side by side: " + std::to_string(plan.jobs) +
           (plan.jobs > 1 ? " (their times are spoilt)" : "") +
           "\nUnit of time (10^6 scalar state checks of 7 ASVs): " +
           short_number(report.session.unit()) + " s\n";
}

std::vector<std::string> setting_lines(const core::BenchmarkPlanner& planner) {
    if (planner.external()) return {"planner = " + planner_text(planner)};
    std::vector<std::string> lines{"planner = " + std::string(core::name(planner.planner))};
    core::Planner copy = planner.planner;
    for (const core::Setting& setting : core::settings(copy))
        lines.push_back(setting.name + " = " + core::describe_value(setting));
    return lines;
}

}  // namespace asv::io
