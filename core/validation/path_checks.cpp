#include "core/validation/path_checks.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core::validation {

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

Finding check_cost(double written, double computed, double rounding,
                   const Requirements& requirements) {
    const double off = std::abs(written - computed);
    // A sum that has overflown is no excuse.
    const double allowed = std::isfinite(rounding) ? std::max(requirements.tolerance, rounding)
                                                   : requirements.tolerance;
    Finding finding;
    finding.ok = off <= allowed;
    finding.offender.room = allowed - off;
    return finding;
}

}  // namespace asv::core::validation
