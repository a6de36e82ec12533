#include "io/solution/statistics_file.hpp"

#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"

namespace asv::io {

void write_statistics(const std::filesystem::path& file, const RunStatistics& run) {
    using nlohmann::ordered_json;
    const core::SolveStatistics& spent = run.spent;
    const bool solved = run.status == core::SolveStatus::solved;
    const auto if_solved = [&](auto value) {
        return solved ? ordered_json(value) : ordered_json(nullptr);
    };
    ordered_json history = ordered_json::array();
    for (const auto& [time, cost] : spent.cost_history) history.push_back({time, cost});
    const ordered_json json = {
        {"problem", run.problem},
        {"asv_count", run.asv_count},
        {"obstacle_count", run.obstacle_count},
        {"planner", run.planner},
        {"seed", run.seed},
        {"threads", run.threads},
        {"status", core::name(run.status)},
        {"reason", run.reason},
        {"time_to_first_s", if_solved(spent.time_to_first)},
        {"time_total_s", spent.time_total},
        {"cost_first", if_solved(spent.cost_first)},
        {"cost_of_search", if_solved(spent.cost_of_search)},
        {"cost", if_solved(spent.cost)},
        {"cost_lower_bound", spent.cost_lower_bound},
        {"optimal", if_solved(spent.optimal)},
        {"primitive_steps", run.primitive_steps},
        {"primitive_steps_lower_bound", spent.steps_lower_bound},
        {"tree_nodes", spent.tree_nodes},
        {"iterations", spent.iterations},
        {"state_checks", spent.state_checks},
        {"edge_checks", spent.edge_checks},
        {"cost_history", std::move(history)},
        {"peak_memory_bytes", run.peak_memory_bytes},
        {"version", run.version},
    };
    // A file name need not be UTF-8.
    write_file(file, json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace asv::io
