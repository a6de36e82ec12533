#include "core/bounds/certify/certify.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/bounds/certify/certify_walls.hpp"
#include "core/bounds/chain_limits.hpp"
#include "core/bounds/feasibility.hpp"
#include "core/model/planning_window.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core {

namespace {

AreaProof area_proof(const Problem& problem) {
    const double length = longest_chain(problem);
    const double area = problem.asv_count() < 3 ? 0 : length * length / (2 * std::numbers::pi);
    return {length, area, least_area(problem)};
}

OrientationProof orientation_proof(const Problem& problem) {
    const Requirements& r = problem.requirements;
    return {geometry::signed_area(problem.start), geometry::signed_area(problem.goal),
            (r.max_step + r.tolerance) * 2 * longest_chain(problem), least_area(problem)};
}

}  // namespace

std::optional<InfeasibilityProof> certify_infeasibility(const Problem& problem) {
    if (check_area(problem).proven_infeasible()) return area_proof(problem);
    if (check_orientation(problem).proven_infeasible()) return orientation_proof(problem);
    const Feasibility found = check_separation(problem);
    if (found.cause == Infeasibility::separated)
        return certify_separation(bounded(problem), *found.asv);
    if (found.cause == Infeasibility::corridor_too_low) return certify_corridors(bounded(problem));
    return std::nullopt;
}

}  // namespace asv::core
