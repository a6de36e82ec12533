#include "core/validation/collisions.hpp"

#include <algorithm>
#include <array>

#include "geometry/elementary/functions.hpp"
#include "geometry/predicates/distance.hpp"
#include "geometry/predicates/segment_box.hpp"

namespace asv::core::validation {
namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

std::vector<Box> shrunk(std::span<const Box> boxes, double tolerance) {
    std::vector<Box> result;
    result.reserve(boxes.size());
    for (const Box& box : boxes) result.push_back(geometry::grown(box, -tolerance));
    return result;
}

}  // namespace

Obstacles::Obstacles(std::span<const Box> boxes, double tolerance)
    : tree_(shrunk(boxes, tolerance)) {}

Finding Obstacles::check(State state, double radius) const {
    Finding worst;
    double near = std::max(radius, 0.0);
    for (std::size_t i = 0; i + 1 < state.size(); ++i) {
        const Segment broom{state[i], state[i + 1]};
        tree_.for_each_near(broom, near, [&](std::size_t index, const Box& box) {
            Finding finding = clearance(broom, box);
            finding.offender.broom = i;
            finding.offender.obstacle = index;
            near = std::clamp(finding.offender.room, 0.0, near);
            keep_worse(worst, finding);
        });
    }
    return worst;
}

Finding Obstacles::check_point(const Segment& motion, double radius) const {
    Finding worst = check(std::array{motion.a, motion.b}, radius);
    worst.offender.broom.reset();
    return worst;
}

// The least shift out of a convex set is along the normal of a side of the Minkowski difference,
// whose sides are those of the box and the segment itself, each in both directions.
double penetration(const Segment& segment, const Box& box) {
    const Box around = geometry::bounds(segment);
    double least = std::min({around.high.x - box.low.x, box.high.x - around.low.x,
                             around.high.y - box.low.y, box.high.y - around.low.y});
    const double dx = segment.b.x - segment.a.x;
    const double dy = segment.b.y - segment.a.y;
    const double length = elementary::hypot(dx, dy);
    if (length > 0) {
        double left = 0;
        double right = 0;
        for (const double x : {box.low.x, box.high.x}) {
            for (const double y : {box.low.y, box.high.y}) {
                const double side = (dx * (y - segment.a.y) - dy * (x - segment.a.x)) / length;
                left = std::max(left, side);
                right = std::max(right, -side);
            }
        }
        least = std::min({least, left, right});
    }
    return std::max(least, 0.0);
}

Finding clearance(const Segment& segment, const Box& box) {
    Finding finding;
    finding.ok = !geometry::meets(segment, box);
    finding.offender.room =
        finding.ok ? geometry::distance(segment, box) : -penetration(segment, box);
    return finding;
}

}  // namespace asv::core::validation
