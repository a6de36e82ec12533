#include "io/benchmark/record/record_json.hpp"

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "core/benchmark/summary.hpp"

namespace asv::io {

namespace {

using nlohmann::ordered_json;

template <class Value>
ordered_json value_or_null(bool known, const Value& value) {
    return known ? ordered_json(value) : ordered_json(nullptr);
}

std::string_view name(core::BodyKind body) {
    return body_names[static_cast<std::size_t>(body)];
}

/// What one session tells of itself.
ordered_json part_json(const BenchmarkSession& session) {
    return {{"started_utc", utc_text(session.started)},
            {"host", session.host},
            {"cpu", session.cpu},
            {"processors", session.processors},
            {"total_s", session.total},
            {"unit_s", session.unit()},
            {"unit_before_s", session.unit_before},
            {"unit_after_s", session.unit_after}};
}

ordered_json problems_json(const core::BenchmarkPlan& plan) {
    ordered_json list = ordered_json::array();
    for (const core::BenchmarkProblem& problem : plan.problems) {
        list.push_back({{"name", problem.name},
                        {"file", problem.file},
                        {"body", name(problem.problem.body_kind())},
                        {"asv_count", problem.problem.asv_count()},
                        {"obstacle_count", problem.problem.obstacles.size()},
                        {"digest", problem.digest}});
        for (const auto& [key, value] : problem.parameters) list.back()["parameters"][key] = value;
    }
    return list;
}

ordered_json planners_json(const core::BenchmarkPlan& plan) {
    ordered_json list = ordered_json::array();
    for (const core::BenchmarkPlanner& planner : plan.planners) {
        if (planner.external()) {
            list.push_back({{"label", planner.label},
                            {"planner", external_name},
                            {"command", planner.command}});
            continue;
        }
        core::Planner copy = planner.planner;
        ordered_json given = ordered_json::array(), settings = ordered_json::object();
        for (const auto& [key, value] : planner.settings) given.push_back(key + "=" + value);
        for (const core::Setting& setting : core::settings(copy))
            settings[setting.name] = core::describe_value(setting);
        list.push_back({{"label", planner.label},
                        {"planner", core::name(planner.planner)},
                        {"given", std::move(given)},
                        {"settings", std::move(settings)}});
    }
    return list;
}

}  // namespace

ordered_json session_record(const BenchmarkReport& report) {
    const core::BenchmarkPlan& plan = report.plan;
    ordered_json json = part_json(report.session);
    json["version"] = report.session.version;
    json["parts"] = ordered_json::array();
    for (const BenchmarkSession& part : report.session.parts)
        json["parts"].push_back(part_json(part));
    json["time_limit_s"] = plan.time_limit;
    json["optimize_s"] = plan.optimize;
    json["threads"] = plan.threads;
    json["memory_limit_mb"] = value_or_null(plan.memory_limit > 0, plan.memory_limit);
    json["jobs"] = plan.jobs;
    json["directions"] = ordered_json::array();
    for (const core::Direction direction : plan.directions)
        json["directions"].push_back(core::name(direction));
    json["first_seed"] = plan.first_seed;
    json["seeds"] = plan.seeds;
    json["complete"] = report.complete();
    return json;
}

ordered_json plan_record(const BenchmarkReport& report) {
    return {{"format", runs_format},
            {"session", session_record(report)},
            {"problems", problems_json(report.plan)},
            {"planners", planners_json(report.plan)}};
}

ordered_json run_record(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run) {
    const core::SolveStatistics& spent = run.spent;
    const bool solved = run.solved();
    ordered_json history = ordered_json::array();
    for (const auto& [time, cost] : spent.cost_history) history.push_back({time, cost});
    const std::optional<double> ratio = core::cost_ratio(run);
    return {{"problem", plan.problems[run.place.problem].name},
            {"planner", plan.planners[run.place.planner].label},
            {"direction", core::name(run.place.direction)},
            {"seed", run.place.seed},
            {"status", core::name(run.status)},
            {"reason", run.reason},
            {"time_to_first_s", value_or_null(solved, spent.time_to_first)},
            {"time_total_s", spent.time_total},
            {"cost_first", value_or_null(solved, spent.cost_first)},
            {"cost_of_search", value_or_null(solved, spent.cost_of_search)},
            {"cost", value_or_null(solved, spent.cost)},
            {"cost_lower_bound", value_or_null(spent.cost_lower_bound > 0, spent.cost_lower_bound)},
            {"cost_ratio", value_or_null(ratio.has_value(), ratio.value_or(0))},
            {"optimal", value_or_null(solved, spent.optimal)},
            {"primitive_steps", run.primitive_steps},
            {"primitive_steps_lower_bound",
             value_or_null(spent.steps_lower_bound > 0, spent.steps_lower_bound)},
            {"tree_nodes", spent.tree_nodes},
            {"iterations", spent.iterations},
            {"state_checks", spent.state_checks},
            {"edge_checks", spent.edge_checks},
            {"cost_history", std::move(history)},
            {"peak_memory_bytes",
             value_or_null(run.peak_memory_bytes.has_value(), run.peak_memory_bytes.value_or(0))},
            {"command", solve_command(plan, run.place)}};
}

}  // namespace asv::io
