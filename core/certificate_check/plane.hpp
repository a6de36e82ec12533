#pragma once

#include <optional>
#include <vector>

#include "core/certificate_check/exact.hpp"

namespace asv::core::certificate_check {

struct Place {
    Number x, y;
};

/// Closed; may be a segment or a point.
struct Rectangle {
    Number left, right, bottom, top;
};

/// In a plane with closed walls, of which the part outside the bounds is a wall as well.
enum class Connection {
    connected,
    separated,
    in_a_wall  ///< one of the two places is
};

/// Of two places: by colours that spread over the grid of all lines on which a side of a rectangle
/// lies. O(k^2) for k walls, of which half a bit for each pair is held.
Connection connection(const std::vector<Rectangle>& walls, const std::optional<Rectangle>& bounds,
                      const Place& from, const Place& to);

}  // namespace asv::core::certificate_check
