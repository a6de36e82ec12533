#include "core/bounds/chain_limits.hpp"

namespace asv::core {

double longest_chain(const Problem& problem) {
    const Requirements& r = problem.requirements;
    return static_cast<double>(problem.asv_count() - 1) * (r.broom_length + r.tolerance);
}

double least_area(const Problem& problem) {
    return problem.requirements.min_area(problem.asv_count()) - problem.requirements.tolerance;
}

bool keeps_orientation(const Problem& problem) {
    // While the ASVs move straight by at most a step h, the area changes by at most h times half
    // the sum of the polygon's diagonals from each vertex to the next but one, hence by at most h
    // times its perimeter, which is below twice the chain's length. Less than that cannot lead from
    // the least area on one side to that on the other.
    const Requirements& r = problem.requirements;
    const double change = (r.max_step + r.tolerance) * 2 * longest_chain(problem);
    return change < 2 * least_area(problem);
}

}  // namespace asv::core
