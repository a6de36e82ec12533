#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/model/requirements.hpp"
#include "geometry/primitives.hpp"

/// Chains that are told by their turns or by a name, instead of by the place of every ASV.

namespace asv::core {

/// The ASVs of a chain whose first one stands at the given point and whose first broom has the
/// given heading; turns (one fewer than brooms) and heading in radians, to the left positive.
std::vector<geometry::Point> chain_positions(std::span<const double> turns, double heading,
                                             const geometry::Point& first, double broom_length);

/// Where a shape lies. A clockwise one is the mirror image, at the heading, of the other.
struct ShapePlace {
    geometry::Point first;   ///< where ASV 1 stands
    double heading = 0;      ///< against the x axis, radians; each shape says of what
    bool clockwise = false;  ///< do the ASVs go round their area clockwise?
};

/// How far an arc or a hook bends from its first broom to its last one, radians. By default a third
/// of a full turn: from three ASVs on, such a bend encloses the usual least area.
inline constexpr double usual_bend = 2 * std::numbers::pi / 3;

/// The flattest chain that encloses a little more than the least area (see flat_area()): ASV n lies
/// ahead of ASV 1 at the heading, the brooms between them in a line beside that, but for those that
/// rise to it and fall from it. Throws std::invalid_argument, as the others do, which says what
/// requirement on its shape the chain would violate; no shape of two ASVs meets them.
std::vector<geometry::Point> line_chain(std::size_t asv_count, const Requirements& requirements,
                                        const ShapePlace& place);

/// All ASVs on a circle, all turns alike. ASV n lies ahead of ASV 1 at the heading. Precondition:
/// 0 < bend < 2 pi.
std::vector<geometry::Point> arc_chain(std::size_t asv_count, const Requirements& requirements,
                                       const ShapePlace& place, double bend = usual_bend);

/// A straight leg of so many brooms (by default half of them, rounded up) that leads ahead from ASV
/// 1 at the heading, and the rest bent evenly, as on a circle. Precondition: 0 < bend < 2 pi. A leg
/// that leaves no broom to bend, or of none, throws std::invalid_argument as well.
std::vector<geometry::Point> hook_chain(std::size_t asv_count, const Requirements& requirements,
                                        const ShapePlace& place, double bend = usual_bend,
                                        std::optional<std::size_t> leg = std::nullopt);

}  // namespace asv::core
