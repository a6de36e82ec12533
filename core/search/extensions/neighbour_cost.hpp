#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/search/configuration_space.hpp"
#include "core/search/trees/interpolate.hpp"
#include "core/search/trees/tree.hpp"

namespace asv::core {

/// Extension 4: a sample is kept with the probability of its nearest node's quality
/// 1 - (c - c_opt) / (c_max - c_opt), where c is the node's distance to the start plus that to the
/// goal, c_opt that from start to goal and c_max the largest c in the tree: growth stays near the
/// direct way. Heuristically guided RRT (Urmson and Simmons, 2003).
///
/// Reported as "capped at 0.1", and the paper's own pseudo code takes the smaller one of quality
/// and floor, which would only discard nine of ten samples. Its text wants a floor, so that no node
/// is hopeless: built is the larger one of the two.
class NeighbourCost {
  public:
    /// floor: least probability; 1: every sample is kept and none is looked at.
    NeighbourCost(const Query& query, double floor) : query_(query), floor_(floor) {}

    template <ConfigurationSpace Space>
    bool accept(Space& space, const Tree& tree, int side, std::span<const double> row, Rng& rng) {
        if (floor_ >= 1) return true;
        const double best = distance_between(space, query_.start, query_.goal);
        const auto cost = [&](std::uint32_t node) {
            return distance_between(space, query_.start, tree.row(node)) +
                   distance_between(space, tree.row(node), query_.goal);
        };
        const auto index = static_cast<std::size_t>(side);
        for (; seen_[index] < tree.size(); ++seen_[index])
            most_[index] = std::max(most_[index], cost(static_cast<std::uint32_t>(seen_[index])));
        const double range = most_[index] - best;
        const double quality = range > 0 ? 1 - (cost(tree.nearest(row)) - best) / range : 1;
        return rng.uniform() < std::max(quality, floor_);
    }

  private:
    Query query_;
    double floor_;
    std::array<std::size_t, 2> seen_ = {0, 0};
    std::array<double, 2> most_ = {0, 0};
};

}  // namespace asv::core
