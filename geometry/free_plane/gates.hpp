#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::geometry {

/// The rectangle between two boxes, or a box and the border, where no third box meets the shortest
/// line from one to the other.
struct Gate {
    Box gap;
    /// Which boxes; one more than the last for the left border, then right, lower, upper.
    std::array<std::size_t, 2> sides;
};

/// The gates that a way through the plane goes through: it crosses the line from one side to the
/// other. A box in the place of the gap closes the gate.
///
/// way: the points where it bends, from first to last. Takes time for each pair of boxes.
std::vector<Gate> gates_on_way(std::span<const Point> way, std::span<const Box> boxes,
                               const Box& bounds);

}  // namespace asv::geometry
