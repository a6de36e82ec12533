#include "geometry/predicates/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/elementary/functions.hpp"
#include "geometry/predicates/segment_box.hpp"

namespace asv::geometry {

namespace {

// The difference of two unequal doubles is never zero, however small, so zero means inside.
double outside(double x, double low, double high) noexcept {
    return std::max({low - x, x - high, 0.0});
}

// Several times as fast as std::hypot where the squares neither overflow nor lose digits to
// underflow. They, their sum and the root err by half an ulp each: 2u of the result.
double length(double x, double y) noexcept {
    const double square = x * x + y * y;
    return square > 1e-280 && square < 1e280 ? std::sqrt(square) : elementary::hypot(x, y);
}

// Infinite where the point does not project between the ends: one of those is nearer to the box.
double distance_to_interior(const Point& point, const Segment& segment) noexcept {
    const double dx = segment.b.x - segment.a.x;
    const double dy = segment.b.y - segment.a.y;
    const double px = point.x - segment.a.x;
    const double py = point.y - segment.a.y;
    const double along = dx * px + dy * py;
    const double squared_length = dx * dx + dy * dy;
    if (!(along > 0 && along < squared_length)) return std::numeric_limits<double>::infinity();
    // The cross product errs by 3u (|dx py| + |dy px|) <= 6u D |d|, so the quotient by some 10u D.
    return std::fabs(dx * py - dy * px) / std::sqrt(squared_length);
}

}  // namespace

double distance(const Point& point, const Box& box) noexcept {
    const double x = outside(point.x, box.low.x, box.high.x);
    const double y = outside(point.y, box.low.y, box.high.y);
    if (x == 0) return y;
    if (y == 0) return x;
    return length(x, y);
}

double distance(const Segment& segment, const Box& box) noexcept {
    if (meets(segment, box)) return 0;
    double nearest = std::min(distance(segment.a, box), distance(segment.b, box));
    for (const double x : {box.low.x, box.high.x}) {
        for (const double y : {box.low.y, box.high.y}) {
            nearest = std::min(nearest, distance_to_interior({x, y}, segment));
        }
    }
    // Rounding may cancel a corner's distance away although they do not meet.
    return std::max(nearest, std::numeric_limits<double>::denorm_min());
}

}  // namespace asv::geometry
