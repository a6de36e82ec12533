#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/search/trees/interpolate.hpp"
#include "core/search/trees/tree.hpp"

/// What the searches that grow one tree by steps of limited length have in common.

namespace asv::core {

/// Moves the row to where a step from the tree's nearest node toward it ends, unwrapped to that
/// node, which is returned. A row nearer than the step stays.
template <ConfigurationSpace Space>
std::uint32_t step_toward(Space& space, const Tree& tree, double step, std::span<double> row) {
    const std::uint32_t nearest = tree.nearest(row);
    const auto from = tree.row(nearest);
    unwrap(row, from, space.wrapping());
    const double distance = space.distance(from, row);
    if (distance > step) interpolate(from, row, step / distance, row);
    return nearest;
}

/// The rows of the nodes, each unwrapped to the one before.
template <class Nodes>
Configurations rows_along(const Tree& tree, const Nodes& nodes, WrappingAngles angles) {
    Configurations rows;
    for (const std::uint32_t node : nodes) {
        const auto row = tree.row(node);
        rows.insert(rows.end(), row.begin(), row.end());
        const std::span<double> all(rows);
        if (all.size() > row.size())
            unwrap(all.last(row.size()), all.last(2 * row.size()).first(row.size()), angles);
    }
    return rows;
}

/// The path from the root to a node.
inline Configurations path_to(const Tree& tree, std::uint32_t node, WrappingAngles angles) {
    auto nodes = tree.to_root(node);
    std::reverse(nodes.begin(), nodes.end());
    return rows_along(tree, nodes, angles);
}

}  // namespace asv::core
