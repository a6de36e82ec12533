#pragma once

#include <array>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/validation/report.hpp"

namespace asv::test {

/// What an oracle says of one check of a path.
enum class Verdict {
    holds,
    fails,
    in_doubt  ///< so near to the limit that the rounding of double decides
};

/// The eight checks of a chain's path in the order of core::Check: each by another formula than the
/// validator's, in long double, or exactly where the geometry is exact (collisions).
std::array<Verdict, core::check_count> oracle_verdicts(const core::Problem& problem,
                                                       const core::Solution& solution, double e);

}  // namespace asv::test
