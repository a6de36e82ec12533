#include "core/validation/path_checks.hpp"

#include <cmath>

namespace asv::core::validation {
namespace {

/// No ASV is farther than limit from its counterpart.
Finding check_distances(State from, State to, double limit) {
    Finding worst;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double moved = distance(from[i], to[i]);
        const bool ok = moved <= limit;
        const double room = limit - moved;
        if (worse(ok, room, worst)) worst = at_asv(ok, i, room);
    }
    return worst;
}

}  // namespace

Finding check_end(State state, State wanted, const Requirements& requirements) {
    return check_distances(state, wanted, requirements.tolerance);
}

Finding check_step(State from, State to, const Requirements& requirements) {
    return check_distances(from, to, requirements.max_step + requirements.tolerance);
}

double step_cost(State from, State to) {
    double cost = 0;
    for (std::size_t i = 0; i < from.size(); ++i) cost += distance(from[i], to[i]);
    return cost;
}

Finding check_cost(double written, double computed, const Requirements& requirements) {
    const double off = std::abs(written - computed);
    Finding finding;
    finding.ok = off <= requirements.tolerance;
    finding.offender.room = requirements.tolerance - off;
    return finding;
}

}  // namespace asv::core::validation
