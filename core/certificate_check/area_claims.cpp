#include <vector>

#include "core/certificate_check/claims.hpp"

namespace asv::core::certificate_check {

namespace {

/// Of the closed polygon, exactly; positive where it turns left.
Number signed_area(const std::vector<Point>& state) {
    Number twice = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const Point& a = state[i];
        const Point& b = state[(i + 1) % state.size()];
        twice += exact(a.x) * exact(b.y) - exact(b.x) * exact(a.y);
    }
    return twice / 2;
}

bool is_chain(const Problem& problem, Claims& claims) {
    const bool chain = problem.body_kind() == BodyKind::chain;
    if (!chain) claims.add("body", false, "only chains of ASVs have to enclose an area");
    return chain;
}

}  // namespace

void check(const AreaProof& proof, const Problem& problem, Claims& claims) {
    if (!is_chain(problem, claims)) return;
    const Limits limits = limits_of(problem);
    // A curve encloses most together with its chord when it is half a circle (Dido).
    const Number greatest =
        limits.asv_count < 3 ? Number(0) : limits.chain * limits.chain / (2 * pi_below());
    claims.add_number("chain length", proof.chain_length, limits.chain);
    claims.add_number("greatest area", proof.greatest_area, greatest);
    claims.add_number("required area", proof.required_area, limits.required_area);
    claims.add("too little area", greatest < limits.required_area,
               text_of(greatest) + " at most, " + text_of(limits.required_area) + " required");
}

void check(const OrientationProof& proof, const Problem& problem, Claims& claims) {
    if (!is_chain(problem, claims)) return;
    const Limits limits = limits_of(problem);
    const Number start = signed_area(problem.start), goal = signed_area(problem.goal);
    // While each vertex of a polygon moves straight by at most h, the area changes at a rate of at
    // most h / 2 times the sum of the diagonals from each vertex to the next but one, which are
    // together at most twice the perimeter, and that is at most twice the chain.
    const Number change = 2 * limits.step * limits.chain;
    const Number& least = limits.required_area;
    claims.add_number("area at the start", proof.start_area, start);
    claims.add_number("area at the goal", proof.goal_area, goal);
    claims.add_number("greatest change", proof.greatest_change, change);
    claims.add_number("required area", proof.required_area, least);
    claims.add("opposite", start * goal < 0,
               start * goal < 0 ? "start and goal turn in opposite directions"
                                : "start and goal turn in one direction");
    const bool enough = abs(start) >= least && abs(goal) >= least;
    claims.add("no step turns over", enough && change < 2 * least,
               "the area changes by " + text_of(change) + " at most, " + text_of(2 * least) +
                   " are needed");
}

}  // namespace asv::core::certificate_check
