#pragma once

#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::core {

/// The gates that a way through the plane goes through. A gate is the rectangle between two boxes,
/// or a box and the border, where no third box meets the shortest line from one to the other; a way
/// goes through it where it crosses this line. A box in its place closes the gate.
///
/// way: the points where it bends, from first to last. Takes time for each pair of boxes.
std::vector<geometry::Box> gates_on_way(std::span<const geometry::Point> way,
                                        std::span<const geometry::Box> boxes,
                                        const geometry::Box& bounds);

}  // namespace asv::core
