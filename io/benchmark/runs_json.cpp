#include "io/benchmark/runs_json.hpp"

#include <optional>

#include <nlohmann/json.hpp>

#include "core/benchmark/comparison.hpp"
#include "core/benchmark/summary.hpp"
#include "io/benchmark/wording.hpp"

namespace asv::io {

namespace {

using core::BenchmarkRun;
using core::statistics::CensoredValue;
using core::statistics::Interval;
using core::statistics::Spread;
using nlohmann::ordered_json;

template <class Value>
ordered_json value_or_null(bool known, const Value& value) {
    return known ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json session_json(const BenchmarkReport& report) {
    const core::BenchmarkPlan& plan = report.plan;
    const BenchmarkSession& session = report.session;
    return {{"version", session.version},
            {"started_utc", utc_text(session.started)},
            {"host", session.host},
            {"cpu", session.cpu},
            {"processors", session.processors},
            {"total_s", session.total},
            {"unit_s", session.unit()},
            {"unit_before_s", session.unit_before},
            {"unit_after_s", session.unit_after},
            {"time_limit_s", plan.time_limit},
            {"optimize_s", plan.optimize},
            {"threads", plan.threads},
            {"jobs", plan.jobs},
            {"note", spoilt_note(plan)},
            {"complete", report.complete()}};
}

ordered_json problems_json(const core::BenchmarkPlan& plan) {
    ordered_json list = ordered_json::array();
    for (const core::BenchmarkProblem& problem : plan.problems)
        list.push_back({{"name", problem.name},
                        {"file", problem.file},
                        {"asv_count", problem.problem.asv_count()},
                        {"obstacle_count", problem.problem.obstacles.size()}});
    return list;
}

ordered_json planners_json(const core::BenchmarkPlan& plan) {
    ordered_json list = ordered_json::array();
    for (const core::BenchmarkPlanner& planner : plan.planners) {
        core::Planner copy = planner.planner;
        ordered_json settings = ordered_json::object();
        for (const core::Setting& setting : core::settings(copy))
            settings[setting.name] = core::describe_value(setting);
        list.push_back({{"label", planner.label},
                        {"planner", core::name(planner.planner)},
                        {"settings", std::move(settings)}});
    }
    return list;
}

ordered_json spread_json(const Spread& spread) {
    if (spread.count == 0) return nullptr;
    return {{"count", spread.count},   {"least", spread.least},
            {"median", spread.median}, {"greatest", spread.greatest},
            {"mean", spread.mean},     {"deviation", spread.deviation}};
}

ordered_json interval_json(const Interval& interval) {
    return {interval.low, interval.high};
}

/// Where "exceeds", the value is known to be greater only.
ordered_json censored_json(const CensoredValue& value) {
    return {{"value", value.value}, {"exceeds", value.censored}};
}

/// Of all runs, those that are not solved censored at the time limit.
ordered_json time_to_solution_json(const core::Summary& row) {
    const auto quantile = [&](double share) {
        return censored_json(core::statistics::quantile(row.time_to_solution, share));
    };
    return {{"median", quantile(0.5)},
            {"median_interval",
             {censored_json(row.median_time.low), censored_json(row.median_time.high)}},
            {"quartiles", {quantile(0.25), quantile(0.75)}},
            {"quantile_90", quantile(0.9)},
            {"par2", core::statistics::penalised_mean(row.time_to_solution)}};
}

ordered_json summary_json(const BenchmarkReport& report) {
    ordered_json list = ordered_json::array();
    for (const core::Summary& row : core::summarise(report.plan, report.runs))
        list.push_back({{"problem", report.plan.problems[row.problem].name},
                        {"planner", report.plan.planners[row.planner].label},
                        {"direction", core::name(row.direction)},
                        {"runs", row.runs},
                        {"solved", row.solved},
                        {"success_interval", interval_json(row.success)},
                        {"time_to_solution_s", time_to_solution_json(row)},
                        {"time_to_first_s", spread_json(row.time_to_first)},
                        {"tree_nodes", spread_json(row.nodes)},
                        {"state_checks", spread_json(row.state_checks)},
                        {"cost_first", spread_json(row.cost_first)},
                        {"cost", spread_json(row.cost)},
                        {"cost_median_interval",
                         value_or_null(row.cost.count > 0, interval_json(row.median_cost))},
                        {"cost_ratio", spread_json(row.ratio)}});
    return list;
}

ordered_json comparisons_json(const BenchmarkReport& report) {
    ordered_json list = ordered_json::array();
    for (const core::Comparison& row : core::compare_planners(report.plan, report.runs))
        list.push_back({{"of", row.measure == core::Measure::time ? "time" : "cost"},
                        {"first", report.plan.planners[row.first].label},
                        {"second", report.plan.planners[row.second].label},
                        {"pairs", row.test.pairs},
                        {"differing_pairs", row.test.differing},
                        {"ratio", row.ratio},
                        {"ratio_interval", interval_json(row.ratio_interval)},
                        {"a12", row.chance_of_less},
                        {"first_better", row.first_better},
                        {"second_better", row.second_better},
                        {"positive_ranks", row.test.positive_ranks},
                        {"negative_ranks", row.test.negative_ranks},
                        {"p", row.test.p},
                        {"p_exact", row.test.exact},
                        {"p_holm", row.corrected_p}});
    return list;
}

ordered_json run_json(const core::BenchmarkPlan& plan, const BenchmarkRun& run) {
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

}  // namespace

std::string runs_json(const BenchmarkReport& report) {
    ordered_json runs = ordered_json::array();
    for (const BenchmarkRun& run : report.runs) runs.push_back(run_json(report.plan, run));
    const ordered_json json = {
        {"session", session_json(report)},         {"problems", problems_json(report.plan)},
        {"planners", planners_json(report.plan)},  {"summary", summary_json(report)},
        {"comparisons", comparisons_json(report)}, {"runs", std::move(runs)}};
    // A file name need not be UTF-8.
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace asv::io
