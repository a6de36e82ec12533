#pragma once

#include <cstddef>
#include <vector>

#include "core/model/requirements.hpp"

/// Two shapes that say how little room a chain needs: the flattest one, which decides whether it
/// passes a straight corridor as a whole, and the roundest one, which turns on the spot.

namespace asv::core {

/// The largest area that a convex chain of the given number of brooms encloses together with its
/// closing side while it lies in a strip of the given height, along the strip.
///
/// Derivation. Let the closing side lie on the lower wall; the chain then rises to the upper wall,
/// runs along it, and comes down again. Every broom on the upper wall adds height * length. Mirror
/// a rise of k brooms at the lower wall: 2k brooms over a chord of 2 * height, whose area is
/// largest when all joints lie on one circle. With half_angle a of a broom seen from the centre,
/// radius R = length / (2 sin a) and height = R sin(2 k a), the rise encloses
/// R^2 / 4 * (2 k sin 2a - sin 4ka). Brooms of a rise that is too long would bulge through the
/// upper wall, so k is the largest number whose last broom does not fall: (2 k - 1) a <= pi / 2.
/// The rest of the rises is a matter of adding up. Low strips have k = 1: a trapezoid of area
/// height * ((brooms - 2) * length + sqrt(length^2 - height^2)).
///
/// Precondition: brooms >= 2, broom_length > 0, 0 < height <= brooms * broom_length / 5 (above
/// that the chain no longer lies along the strip). Throws std::invalid_argument otherwise.
double flat_area(std::size_t brooms, double broom_length, double height);

/// The least height of a straight corridor, longer than the chain, that the chain can lie in:
/// flat_area equals the minimum area there. 0.02266 for 7 ASVs with the classic requirements.
/// Precondition: asv_count >= 3 and the requirements leave such a height (the classic ones do);
/// throws std::invalid_argument otherwise.
double min_flat_height(std::size_t asv_count, const Requirements& requirements = {});

/// The turns (asv_count - 2, all >= 0) of the chain that has flat_area in a strip of this height.
/// Its first broom rises at flat_chain_heading() from the lower wall, clockwise chains fall off.
/// Precondition: as for flat_area.
std::vector<double> flat_chain_turns(std::size_t asv_count, double broom_length, double height);

/// The heading of the first broom of a clockwise flat chain that lies along +x, in radians; the
/// last broom has the opposite one.
double flat_chain_heading(std::size_t asv_count, double broom_length, double height);

/// Diameter of the circle through the ASVs when they stand at the corners of a regular polygon with
/// asv_count sides, the closing side as long as a broom. The area of that polygon is above the
/// minimum for every number of ASVs. Precondition: asv_count >= 3.
double round_diameter(std::size_t asv_count, const Requirements& requirements = {});

}  // namespace asv::core
