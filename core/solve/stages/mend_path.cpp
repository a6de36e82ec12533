#include "core/solve/stages/mend_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asv::core {

namespace {

/// Iterations of each search that joins two pieces: enough to get round what has moved, few where
/// a search for another way is worth more.
constexpr std::size_t iterations_to_join = 300;
/// Of so many states of the last path one is looked at.
constexpr std::size_t states_for_each_row = 4;

bool is_finite(const Path& path) {
    return std::all_of(path.points().begin(), path.points().end(), [](const Point& point) {
        return std::isfinite(point.x) && std::isfinite(point.y);
    });
}

Path thinned(const Path& path) {
    Path thin(path.asv_count());
    for (std::size_t i = 0; i < path.size(); i += states_for_each_row)
        thin.push_back(path.state(i));
    thin.push_back(path.state(path.size() - 1));
    return thin;
}

}  // namespace

std::optional<RaceResult> mend_path(const SolveCall& call, const Path& last,
                                    SolveStatistics& statistics) {
    if (last.empty() || last.asv_count() != call.problem.asv_count() || !is_finite(last))
        return std::nullopt;
    Limits limits;
    limits.deadline = call.deadline();
    limits.stop = call.options.stop;
    limits.max_iterations = iterations_to_join;
    Rng rng(call.seed(0));
    Attempt attempt = call.solver.mend(call.frame.path_in(thinned(last)), limits, rng);
    statistics.state_checks += attempt.checks.state_checks;
    statistics.edge_checks += attempt.checks.edge_checks;
    if (attempt.search.outcome != Outcome::solved) return std::nullopt;
    RaceResult mended;
    mended.winner = 0;
    mended.mended = true;
    mended.path = std::move(attempt.search.path);
    statistics.iterations = attempt.search.iterations;
    statistics.time_to_first = call.clock.elapsed();
    statistics.cost_first = call.frame.cost_back(call.solver.cost(mended.path));
    statistics.cost_of_search = statistics.cost_first;
    statistics.cost_history = {{statistics.time_to_first, statistics.cost_first}};
    if (call.options.on_path) call.options.on_path(statistics.time_to_first);
    return mended;
}

}  // namespace asv::core
