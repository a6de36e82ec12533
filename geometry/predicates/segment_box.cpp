#include "geometry/predicates/segment_box.hpp"

#include "geometry/predicates/orientation.hpp"

namespace asv::geometry {

// Two convex sets are apart when the normal of one of their sides separates them: here an axis or
// the normal of the segment. On the segment's normal, one diagonal of the box spans its shadow.
bool meets(const Segment& segment, const Box& box) noexcept {
    if (is_empty(box) || !overlap(bounds(segment), box)) return false;
    const auto& [a, b] = segment;
    if (a.x == b.x || a.y == b.y || contains(box, a) || contains(box, b)) return true;
    const bool rising = (a.x < b.x) == (a.y < b.y);
    const Point left{box.low.x, rising ? box.high.y : box.low.y};
    const Point right{box.high.x, rising ? box.low.y : box.high.y};
    return orientation(a, b, left) * orientation(a, b, right) <= 0;
}

}  // namespace asv::geometry
