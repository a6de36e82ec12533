#include "core/solve/stages/find_bounds.hpp"

#include <algorithm>

#include "core/bounds/lower_bound.hpp"

namespace asv::core {

void find_bounds(const SolveCall& call, double reserve, SolveStatistics& statistics) {
    // Who has asked for a stop waits for the path.
    constexpr double patience = 0.02;
    double left = call.clock.left() - reserve;
    if (call.options.stop.stop_requested()) left = std::min(left, patience);
    const double preparation = 1e-3 + 1e-5 * static_cast<double>(call.problem.obstacles.size());
    if (left < preparation) return;
    // At most some quarter of the time goes into searches, since the path that was found must not
    // come too late.
    constexpr double cells_per_second = 5e5;
    const auto effort =
        static_cast<std::size_t>(std::min(cells_per_second * left, 1.0 * max_bound_effort));
    const CostLowerBound bound = cost_lower_bound(call.problem, Reading::intended, effort);
    statistics.cost_lower_bound = bound.total;
    statistics.steps_lower_bound = steps_lower_bound(call.problem, bound);
}

}  // namespace asv::core
