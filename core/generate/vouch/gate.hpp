#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/model/problem.hpp"

namespace asv::core {

/// A straight horizontal corridor between the upper side of one box and the lower side of another.
struct Gate {
    Box free;  ///< as long as both boxes are abreast of each other

    double height() const { return free.high.y - free.low.y; }
};

/// The corridors of at most the given height that no other box reaches into. O(m^3).
std::vector<Gate> find_gates(std::span<const Box> obstacles, double max_height);

/// How a chain bends on its way through a gate: in both rooms it lies on three sides of a
/// rectangle, of which the corridor's axis is the lower (or, mirrored, the upper) side. All its
/// joints stay on that rectangle's outline, so they are in convex position whatever they do.
struct GateRail {
    Gate gate;
    bool mirrored = false;       ///< the legs hang down instead of standing up
    double distance_before = 0;  ///< from the first mouth to the upright leg, beyond one broom
    double distance_after = 0;   ///< the same at the second mouth
    double leg = 0;              ///< length of the upright leg
    double slack = 0;            ///< distance of the brooms to the corridor's walls
};

/// The chain's ASVs, counter-clockwise, when the joint behind the leading ASV stands at the
/// distance `advance` along the rail. The first and last ASV stand off the axis by what the
/// corridor leaves, which gives the chain its area while it is inside as a whole. Empty when the
/// rail is too short.
std::vector<Point> chain_on_rail(const GateRail& rail, std::size_t asv_count, double broom_length,
                                 double advance);

/// The advance at which the leading ASV is about to enter (first), and at which the last one has
/// just left (second).
struct RailSpan {
    double enter;
    double leave;
};
RailSpan rail_span(const GateRail& rail, std::size_t asv_count, double broom_length);

}  // namespace asv::core
