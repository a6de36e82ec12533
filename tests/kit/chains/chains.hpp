#pragma once

#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

/// The positions of chains that are made by hand, with brooms of the length 0.05.

namespace asv::test {

using geometry::Point;
using Points = std::vector<Point>;

inline constexpr double right_angle = std::numbers::pi / 2;

/// Brooms from `first` on, the first with the given heading, then turn by turn; two ASVs more than
/// turns.
Points chain_with_turns(Point first, double heading, std::span<const double> turns);
Points chain_with_turns(Point first, double heading, std::initializer_list<double> turns);

/// n >= 1 ASVs, each broom turned by `turn` against the one before.
Points arc(std::size_t n, Point first, double heading, double turn);

/// n ASVs around their centroid on most of a regular polygon: valid for every n but 2, and with
/// room in every requirement; counter-clockwise. `closing` in (0, 1] is the share of the polygon's
/// turns: with 1 the closing side is as long as a broom.
Points ring(std::size_t n, Point centroid, double heading, double closing = 0.93);

/// Three ASVs, a right angle to the left at the second: (0.5, 0.5), (0.55, 0.5), (0.55, 0.55).
Points corner();

Points moved(Points points, double dx, double dy);

/// The other way along the chain.
Points reversed(Points points);

/// The longest way of an ASV from one state of a chain to another, as the crow flies.
double farthest_move(std::span<const Point> from, std::span<const Point> to);

}  // namespace asv::test
