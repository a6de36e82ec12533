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

/// The eight checks of a chain's path in the order of core::Check, from the exact coordinates: the
/// room that is left to each limit has a hundred digits, and what meets an obstacle is decided in
/// exact arithmetic.
///
/// The reference computes in double, so its verdict is another one where the exact room is less
/// than its formula rounds. Only there the oracle is in doubt; each bound, some units of u = 2^-53
/// relative to the numbers involved, is derived beside its formula. The hundred digits of the room
/// err by 10^-80 of that at most. Lengths and tolerances are the numbers that the doubles stand
/// for; the limits derived from them are exact.
std::array<Verdict, core::check_count> oracle_verdicts(const core::Problem& problem,
                                                       const core::Solution& solution, double e);

}  // namespace asv::test
