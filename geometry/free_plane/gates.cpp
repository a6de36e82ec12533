#include "geometry/free_plane/gates.hpp"

#include <algorithm>
#include <utility>

#include "geometry/boxes/span.hpp"
#include "geometry/elementary/functions.hpp"
#include "geometry/predicates/segment_box.hpp"

namespace asv::geometry {

namespace {

/// By so much the line of a gate reaches into the boxes on both sides, which a way may graze.
constexpr double overreach = 1e-4;

struct Opening {
    Box gap;
    Segment line;  ///< from one box to the other, with its overreach
};

/// What is between two boxes that do not touch. Where they lie side by side the line is in the
/// middle, else it leads from corner to corner.
Opening opening_between(const Box& a, const Box& b) {
    Opening opening;
    const Span x = between(x_span(a), x_span(b));
    const Span y = between(y_span(a), y_span(b));
    opening.gap = {{x.low, y.low}, {x.high, y.high}};
    const bool apart_x = apart(x_span(a), x_span(b)) > 0;
    const bool apart_y = apart(y_span(a), y_span(b)) > 0;
    const Point middle = centre(opening.gap);
    Point half{apart_x ? middle.x - x.low : 0, apart_y ? middle.y - y.low : 0};
    const double length = elementary::hypot(half.x, half.y);
    const double stretch = (length + overreach) / length;
    half = {half.x * stretch, half.y * stretch};
    // Corner to corner is the falling diagonal where one box is to the right of the other, below.
    if (apart_x && apart_y && (a.low.x > b.high.x) != (a.low.y > b.high.y)) half.y = -half.y;
    opening.line = {{middle.x - half.x, middle.y - half.y}, {middle.x + half.x, middle.y + half.y}};
    return opening;
}

double side_of(const Segment& line, const Point& point) {
    return (line.b.x - line.a.x) * (point.y - line.a.y) -
           (line.b.y - line.a.y) * (point.x - line.a.x);
}

bool cross(const Segment& a, const Segment& b) {
    return side_of(a, b.a) * side_of(a, b.b) <= 0 && side_of(b, a.a) * side_of(b, a.b) <= 0;
}

bool crosses(std::span<const Point> way, const Segment& line) {
    for (std::size_t i = 1; i < way.size(); ++i)
        if (cross({way[i - 1], way[i]}, line)) return true;
    return false;
}

/// Four boxes round the bounds.
std::vector<Box> outside(const Box& bounds) {
    const Point &low = bounds.low, &high = bounds.high;
    return {{{low.x - 1, low.y}, {low.x, high.y}},
            {{high.x, low.y}, {high.x + 1, high.y}},
            {{low.x, low.y - 1}, {high.x, low.y}},
            {{low.x, high.y}, {high.x, high.y + 1}}};
}

}  // namespace

std::vector<Gate> gates_on_way(std::span<const Point> way, std::span<const Box> boxes,
                               const Box& bounds) {
    std::vector<Box> all(boxes.begin(), boxes.end());
    for (const Box& box : outside(bounds)) all.push_back(box);
    const auto others_meet = [&](const Segment& line, std::size_t i, std::size_t j) {
        for (std::size_t k = 0; k < all.size(); ++k)
            if (k != i && k != j && meets(line, all[k])) return true;
        return false;
    };
    std::vector<Gate> gates;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (overlap(all[i], all[j])) continue;
            const auto [gap, line] = opening_between(all[i], all[j]);
            if (crosses(way, line) && !others_meet(line, i, j)) gates.push_back({gap, {i, j}});
        }
    }
    return gates;
}

}  // namespace asv::geometry
