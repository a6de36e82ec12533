#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/search/extensions/reported.hpp"
#include "core/search/sampling/samplers.hpp"
#include "core/search/setting.hpp"

namespace asv::core {

/// Extension 5, reported as "Gaussian bridge": a sample is kept when some, but not all, of the
/// normal displacements around it collide; without displacements every sample is kept.
struct PassageFilter {
    std::size_t displacements = 5;
    double sigma = 0.05;

    template <SampledSpace Space>
    bool accept(Space& space, std::span<const double> row, Rng& rng) const {
        return at_passage(space, rng, row, displacements, sigma);
    }
};

inline std::vector<Setting> settings_of(PassageFilter& options) {
    return {
        {.name = "filter-draws",
         .meaning = "draws around a sample that the filter looks at",
         .value = number(options.displacements, 0, 1000),
         .why = "as reported; with 0 every sample is kept",
         .source = extensions_report},
        {.name = "filter-sigma",
         .meaning = "their deviation; 0: a twentieth of the longest side",
         .value = number(options.sigma, 0, 1e3, in_metric),
         .why = "as reported",
         .source = extensions_report},
    };
}

}  // namespace asv::core
