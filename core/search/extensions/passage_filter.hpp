#pragma once

#include <cstddef>
#include <span>

#include "core/search/sampling/samplers.hpp"

namespace asv::core {

/// Extension 5, reported as "Gaussian bridge": a sample is kept when some, but not all, of the
/// normal displacements around it collide.
struct PassageFilter {
    std::size_t displacements = 5;  ///< 0: every sample is kept
    double sigma = 0.05;            ///< of each coordinate, in the metric

    template <SampledSpace Space>
    bool accept(Space& space, std::span<const double> row, Rng& rng) const {
        return at_passage(space, rng, row, displacements, sigma);
    }
};

}  // namespace asv::core
