#include "io/benchmark/runs_json.hpp"

#include <nlohmann/json.hpp>

#include "core/benchmark/comparison.hpp"
#include "core/benchmark/summary.hpp"
#include "io/benchmark/record/record_json.hpp"
#include "io/benchmark/wording.hpp"

namespace asv::io {

namespace {

using core::statistics::CensoredValue;
using core::statistics::Interval;
using core::statistics::Spread;
using nlohmann::ordered_json;

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
                         row.cost.count > 0 ? interval_json(row.median_cost) : ordered_json()},
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

}  // namespace

std::string runs_json(const BenchmarkReport& report) {
    ordered_json json = plan_record(report);
    json["session"]["note"] = spoilt_note(report.plan);
    json["summary"] = summary_json(report);
    json["comparisons"] = comparisons_json(report);
    ordered_json& runs = json["runs"] = ordered_json::array();
    for (const core::BenchmarkRun& run : report.runs) runs.push_back(run_record(report.plan, run));
    // A file name need not be UTF-8.
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace asv::io
