#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include "core/search/rng.hpp"
#include "core/search/search_result.hpp"
#include "core/search/trees/nearest.hpp"

namespace asv::core {

/// What a planner needs to know of a body in its world. A configuration is a row of dimension()
/// numbers. The space may keep scratch memory and counters, so it is not const while planning.
template <class Space>
concept ConfigurationSpace = requires(Space& space, Rng& rng, std::span<double> out,
                                      std::span<const double> row, Configurations& visited,
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
    /// The coordinates that are angles and wrap at 2 pi, if there are any.
    { space.wrapping() } -> std::same_as<WrappingAngles>;
};

/// What samplers, roadmaps and optimal trees need beyond that. Wherever two rows go in, the angles
/// that wrap are unwrapped alike (see unwrap() and interpolate()).
template <class Space>
concept SampledSpace = ConfigurationSpace<Space> &&
    requires(Space& space, Rng& rng, std::span<const double> row, std::span<double> out,
             std::size_t coordinate, double sigma) {
    /// The configuration at a point of the unit cube, on which the bounds are mapped evenly:
    /// uniform draws and regular grids are those of the cube. Obstacles are not looked at. False
    /// where the body cannot take it whatever the obstacles (shape requirements).
    { space.from_unit_cube(row, out) } -> std::same_as<bool>;
    /// How long the side of the cube along a coordinate is in the metric: a grid divides long sides
    /// more often.
    { space.extent(coordinate) } -> std::convertible_to<double>;
    /// The row displaced by a normal draw along each coordinate, of deviation sigma in the metric.
    /// It may leave the bounds. row and out do not overlap.
    { space.perturb(rng, row, sigma, out) } -> std::same_as<void>;
    /// Does the body meet an obstacle or leave the bounds there? Its own requirements do not count.
    { space.collides(row) } -> std::same_as<bool>;
    /// Is the configuration valid in every respect?
    { space.valid(row) } -> std::same_as<bool>;
    /// Is the whole straight motion proven valid?
    { space.motion_valid(row, row) } -> std::same_as<bool>;
    /// What the straight motion costs; symmetric, not negative, 0 from a row to itself.
    { space.cost(row, row) } -> std::convertible_to<double>;
    /// What every path from the one to the other costs at least, obstacles or not; it obeys the
    /// triangle inequality. Zero is always right, but guides no search.
    { space.cost_lower_bound(row, row) } -> std::convertible_to<double>;
};

/// A start and a goal, both valid.
struct Query {
    std::span<const double> start;
    std::span<const double> goal;
};

}  // namespace asv::core
