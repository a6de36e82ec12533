#include "io/benchmark/runs_json.hpp"

#include <nlohmann/json.hpp>

#include "core/benchmark/summary.hpp"
#include "io/benchmark/record/record_json.hpp"

namespace asv::io {

namespace {

using core::Spread;
using nlohmann::ordered_json;

ordered_json spread_json(const Spread& spread) {
    if (spread.count == 0) return nullptr;
    return {{"count", spread.count},   {"least", spread.least},
            {"median", spread.median}, {"greatest", spread.greatest},
            {"mean", spread.mean},     {"deviation", spread.deviation}};
}

ordered_json summary_json(const BenchmarkReport& report) {
    ordered_json list = ordered_json::array();
    for (const core::Summary& row : core::summarise(report.plan, report.runs))
        list.push_back({{"problem", report.plan.problems[row.problem].name},
                        {"planner", report.plan.planners[row.planner].label},
                        {"direction", core::name(row.direction)},
                        {"runs", row.runs},
                        {"solved", row.solved},
                        {"time_to_first_s", spread_json(row.time_to_first)},
                        {"tree_nodes", spread_json(row.nodes)},
                        {"state_checks", spread_json(row.state_checks)},
                        {"cost_first", spread_json(row.cost_first)},
                        {"cost", spread_json(row.cost)},
                        {"cost_ratio", spread_json(row.ratio)}});
    return list;
}

}  // namespace

std::string runs_json(const BenchmarkReport& report) {
    ordered_json json = plan_record(report);
    json["summary"] = summary_json(report);
    ordered_json& runs = json["runs"] = ordered_json::array();
    for (const core::BenchmarkRun& run : report.runs) runs.push_back(run_record(report.plan, run));
    // A file name need not be UTF-8.
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace asv::io
