#pragma once

#include "core/certificate_check/exact.hpp"
#include "core/model/problem.hpp"

namespace asv::core::certificate_check {

/// What the requirements leave to any path, each by as much on the lenient side as the validator's
/// double arithmetic may be off.
struct Limits {
    std::size_t asv_count = 0;
    Number tolerance;      ///< e
    Number step;           ///< the farthest that an ASV gets in a primitive step
    Number broom;          ///< the greatest length of one
    Number chain;          ///< of all together
    Number required_area;  ///< of every state
    /// A segment no longer than a step between two places outside of an obstacle that is shrunk by
    /// e keeps out of the obstacle shrunk by this: whatever is in that is farther than half a step
    /// from all places outside.
    Number shrink;
};

Limits limits_of(const Problem& problem);

}  // namespace asv::core::certificate_check
