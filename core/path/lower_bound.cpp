#include "asv/core/path/lower_bound.hpp"

#include <algorithm>
#include <cstddef>

namespace asv::core {

namespace {

/// Cells that the searches of all ASVs together may enter: about a second.
constexpr std::size_t total_effort = 1'000'000;

/// Covers the rounding of lengths of up to a million bends.
constexpr double rounding = 1e-9;

}  // namespace

CostLowerBound cost_lower_bound(const Problem& problem, Reading reading) {
    geometry::FreeSpace space = make_asv_space(problem, reading);
    const std::size_t effort = total_effort / std::max<std::size_t>(1, problem.asv_count());
    CostLowerBound bound;
    for (std::size_t i = 0; i < problem.asv_count(); ++i) {
        const double apart =
            space.shortest_path_at_least(problem.start[i], problem.goal[i], effort);
        const double ends = 2 * problem.requirements.tolerance;
        const double length = std::max(0.0, apart * (1 - rounding) - ends);
        bound.lengths.push_back(length);
        bound.total += length;
    }
    return bound;
}

}  // namespace asv::core
