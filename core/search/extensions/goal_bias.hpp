#pragma once

#include "core/search/rng.hpp"

namespace asv::core {

/// Extension 7: with some probability the sample is the root of the other tree.
struct GoalBias {
    double probability;  ///< 0 to 1

    /// No number is drawn where the probability is 0.
    bool chosen(Rng& rng) const { return probability > 0 && rng.chance(probability); }
};

}  // namespace asv::core
