#pragma once

#include <algorithm>
#include <span>

/// Plain value types of the plane. No invariants beyond those written here, no behaviour.
/// Units: workspace units (the side of the field is 1 in the classic problem).

namespace asv::geometry {

struct Point {
    double x = 0;
    double y = 0;
    friend constexpr bool operator==(const Point&, const Point&) = default;
};

/// Closed segment from a to b; a == b is a point.
struct Segment {
    Point a;
    Point b;
    friend constexpr bool operator==(const Segment&, const Segment&) = default;
};

/// Closed axis-aligned rectangle [low.x, high.x] x [low.y, high.y]. A box with low > high in one
/// coordinate is empty; low == high is a segment or a point.
struct Box {
    Point low;
    Point high;
    friend constexpr bool operator==(const Box&, const Box&) = default;
};

constexpr bool is_empty(const Box& box) {
    return box.low.x > box.high.x || box.low.y > box.high.y;
}

/// Also of boxes whose corners are as large as a double can be.
constexpr Point centre(const Box& box) {
    return {box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2};
}

/// Is the point in the closed box?
constexpr bool contains(const Box& box, const Point& point) {
    return box.low.x <= point.x && point.x <= box.high.x && box.low.y <= point.y &&
           point.y <= box.high.y;
}

/// Do the closed boxes share a point? Precondition: neither is empty.
constexpr bool overlap(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// The smallest box that holds the segment.
constexpr Box bounds(const Segment& segment) {
    return {{std::min(segment.a.x, segment.b.x), std::min(segment.a.y, segment.b.y)},
            {std::max(segment.a.x, segment.b.x), std::max(segment.a.y, segment.b.y)}};
}

/// The smallest box that holds the points. Precondition: at least one.
constexpr Box bounding_box(std::span<const Point> points) {
    Box box{points.front(), points.front()};
    for (const Point& point : points) {
        box.low = {std::min(box.low.x, point.x), std::min(box.low.y, point.y)};
        box.high = {std::max(box.high.x, point.x), std::max(box.high.y, point.y)};
    }
    return box;
}

/// The box with every side moved outwards by margin (inwards where margin is negative).
constexpr Box grown(const Box& box, double margin) {
    return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

/// With x and y exchanged.
constexpr Box transposed(const Box& box) {
    return {{box.low.y, box.low.x}, {box.high.y, box.high.x}};
}

}  // namespace asv::geometry
