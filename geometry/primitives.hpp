#pragma once

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

/// The box with every side moved outwards by margin (inwards where margin is negative).
constexpr Box grown(const Box& box, double margin) {
    return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

}  // namespace asv::geometry
