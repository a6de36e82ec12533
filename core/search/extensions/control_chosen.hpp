#pragma once

#include <limits>
#include <span>

#include "core/search/configuration_space.hpp"
#include "core/search/trees/interpolate.hpp"

namespace asv::core {

/// Extension 6: a sample is kept unless it is farther from the goal than the start is.
struct ControlChosen {
    /// The start's distance is multiplied by it; infinite: every sample is kept.
    double reach;

    template <ConfigurationSpace Space>
    bool accept(Space& space, const Query& query, std::span<const double> row) const {
        if (reach == std::numeric_limits<double>::infinity()) return true;
        return distance_between(space, row, query.goal) <=
               reach * distance_between(space, query.start, query.goal);
    }
};

}  // namespace asv::core
