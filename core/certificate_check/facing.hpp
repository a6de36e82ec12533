#pragma once

#include <string>

#include "core/certificate/certificate.hpp"
#include "core/certificate_check/limits.hpp"
#include "core/certificate_check/plane.hpp"

namespace asv::core::certificate_check {

/// What is between two walls that face each other. Along: y if they are left and right of it, x if
/// they are below and above it; across: the other way.
struct Passage {
    bool upright = false;
    std::optional<std::string> fault;  ///< why they are no such walls; then nothing else is known
    Number gap;                        ///< from wall to wall, before any shrinking
    Number from, to;                   ///< along, where both walls are
    /// Across, from the first wall to the second, each shrunk as a step asks for; the outside of
    /// the bounds by the tolerance, since a step between two places within them stays there.
    Number near, far;

    /// From wall to wall.
    Rectangle cross_section(const Number& along) const;
};

/// Two walls of the problem, each thicker than a step: what moves no farther than that and is in no
/// obstacle shrunk by e cannot get from this side of a wall to the other in a step.
Passage passage_between(const FacingWalls& facing, const Problem& problem, const Limits& limits);

/// "obstacles 1 and 2", "obstacle 3 and the border". Precondition: one is an obstacle.
std::string describe(const FacingWalls& facing);

}  // namespace asv::core::certificate_check
