#pragma once

#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::io {

/// The sides of boxes that may touch and overlap, as the union of the boxes has them.
struct UnionSides {
    std::vector<geometry::Segment> outline;  ///< the border of the union, each stretch once; exact
    /// The rest of the right and upper sides: where two boxes lie side by side, a picture that
    /// smooths edges shows a gap.
    std::vector<geometry::Segment> seams;
};

/// Time: O(m log m) and, for each side, the boxes that it touches. No empty boxes.
UnionSides union_sides(std::span<const geometry::Box> boxes);

}  // namespace asv::io
