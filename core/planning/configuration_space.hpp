#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>

#include "asv/core/planning/nearest.hpp"
#include "asv/core/planning/result.hpp"
#include "asv/core/planning/rng.hpp"

namespace asv::core {

/// What a planner needs to know of a body in its world. A configuration is a row of dimension()
/// numbers. The space may keep scratch memory and counters, so it is not const while planning.
template <class Space>
concept ConfigurationSpace = requires(Space& space, Rng& rng, std::span<double> out,
                                      std::span<const double> row, Rows& visited,
                                      const NearestNeighbours& index) {
    { space.dimension() } -> std::convertible_to<std::size_t>;
    /// An empty index in the space's metric.
    { space.make_index() } -> std::same_as<NearestNeighbours>;
    /// Draws a valid configuration; false when it found none in a bounded number of tries.
    { space.sample(rng, out) } -> std::same_as<bool>;
    /// Moves from a valid row toward a target and appends the rows it passes to visited, the last
    /// one being the target exactly (up to full turns of an angle) when it is reached.
    { space.steer(row, row, visited) } -> std::same_as<Steered>;
    /// Distance in the metric.
    { space.distance(row, row) } -> std::convertible_to<double>;
    /// The index of the angle that wraps at 2 pi, if the space has one.
    { space.wrapping() } -> std::same_as<std::optional<std::size_t>>;
};

/// A start and a goal, both valid.
struct Query {
    std::span<const double> start;
    std::span<const double> goal;
};

}  // namespace asv::core
