// Plans a path and lets the validator judge it, the motion between its states included.

#include "core/solve/replan.hpp"
#include "core/solve/solve.hpp"
#include "tools/playground/engine/answer.hpp"

namespace asv::playground {

namespace {

std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

core::SolveOptions options_of(const Json& json) {
    core::SolveOptions options;
    options.planner = core::planner_named(json.value("planner", "auto"));
    if (json.contains("settings"))
        for (const auto& [key, value] : json["settings"].items())
            core::set(options.planner, key, text_of(value));
    options.seed = json.value("seed", options.seed);
    options.optimize = json.value("optimize", options.optimize);
    options.time_limit = json.value("timeLimit", options.time_limit);
    options.keep_trees = json.value("trees", false);
    options.find_bounds = json.value("bound", true);
    options.certify_motion = true;
    return options;
}

std::string_view status_of(const core::SolveResult& result) {
    return result.status == core::SolveStatus::timeout ? "not found" : name(result.status);
}

/// Why the validator rejects the path; null where it does not.
Json violation(const core::ValidationReport& report) {
    for (const auto* checks : {&report.checks, &report.motion})
        for (const core::CheckResult& check : *checks)
            if (!check.ok()) return std::string(name(check.check)) + ": " + describe(check);
    return nullptr;
}

/// The path and what the validator says of it.
void add_path(const core::SolveResult& result, Answer& answer) {
    answer.json["cost"] = result.solution->cost;
    answer.json["valid"] = result.report.valid();
    answer.json["violation"] = violation(result.report);
    answer.add("states", numbers_of(result.solution->path));
}

void add_trees(const core::SolveResult& result, Answer& answer) {
    for (const core::TreePicture& tree : result.trees) {
        // A roadmap has one tree, whose nodes are all roots; it is shown as that of the start.
        const std::string member =
            tree.root == core::TreeRoot::goal ? "trees.goal." : "trees.start.";
        std::vector<double> points;
        for (const core::Point& point : tree.points)
            points.insert(points.end(), {point.x, point.y});
        answer.add(member + "points", std::move(points));
        answer.add(member + "parents", {tree.parents.begin(), tree.parents.end()});
    }
    if (result.edges.empty()) return;
    std::vector<double> edges;
    for (const auto& edge : result.edges) edges.insert(edges.end(), edge.begin(), edge.end());
    answer.add("trees.edges", std::move(edges));
}

Json history_of(const core::SolveStatistics& statistics) {
    Json history = Json::array();
    for (const auto& [seconds, cost] : statistics.cost_history) history.push_back({seconds, cost});
    return history;
}

}  // namespace

Answer plan(const Request& request) {
    const core::Problem problem = problem_of(request);
    Answer answer;
    answer.json = {{"status", "invalid ends"}, {"reason", ""},  {"cost", nullptr},
                   {"bound", nullptr},         {"seconds", {}}, {"valid", false},
                   {"violation", nullptr},     {"history", {}}, {"trees", nullptr}};
    if (const auto invalid = core::invalid_ends(problem); !invalid.empty()) {
        answer.json["reason"] = core::InvalidEnds(invalid).what();
        return answer;
    }
    const core::SolveOptions options = options_of(request.json);
    const core::SolveResult result =
        request.states.empty()
            ? core::solve(problem, options)
            : core::replan(problem, path_of(request.states, problem.asv_count()), options);
    const core::SolveStatistics& statistics = result.statistics;
    answer.json["status"] = status_of(result);
    answer.json["reason"] = result.reason;
    answer.json["seconds"] = {{"first", statistics.time_to_first},
                              {"total", statistics.time_total}};
    answer.json["history"] = history_of(statistics);
    if (statistics.cost_lower_bound > 0) answer.json["bound"] = statistics.cost_lower_bound;
    if (result.solution) add_path(result, answer);
    add_trees(result, answer);
    return answer;
}

}  // namespace asv::playground
