#include "tests/kit/geometry/visibility_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asv::test {

using geometry::Box;
using geometry::Point;

namespace {

/// Does the segment meet the open box? Clips the segment against the four half planes.
bool crosses_interior(const Point& a, const Point& b, const Box& box) {
    double from = 0;
    double to = 1;
    const auto clip = [&](double start, double direction, double low, double high) {
        if (direction == 0) return low < start && start < high;
        const double first = (low - start) / direction;
        const double second = (high - start) / direction;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
        return true;
    };
    // Stretches this short come from rounding at a corner that is only touched.
    return clip(a.x, b.x - a.x, box.low.x, box.high.x) &&
           clip(a.y, b.y - a.y, box.low.y, box.high.y) && to - from > 1e-12;
}

}  // namespace

double brute_force_shortest_path(std::span<const Box> boxes, const Box& bounds, const Point& from,
                                 const Point& to, double closing) {
    std::vector<Box> closed;
    const Box inside = geometry::grown(bounds, -closing);
    std::vector<Point> nodes{from, to};
    for (const Box& box : boxes) {
        if (box.low.x >= box.high.x || box.low.y >= box.high.y) continue;
        const Box& solid = closed.emplace_back(geometry::grown(box, closing));
        for (const double x : {solid.low.x, solid.high.x}) {
            for (const double y : {solid.low.y, solid.high.y}) {
                if (geometry::contains(inside, {x, y})) nodes.push_back({x, y});
            }
        }
    }
    std::vector<double> length(nodes.size(), std::numeric_limits<double>::infinity());
    std::vector<bool> done(nodes.size(), false);
    length[0] = 0;
    while (true) {
        std::size_t next = nodes.size();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!done[i] && (next == nodes.size() || length[i] < length[next])) next = i;
        }
        if (next == nodes.size() || std::isinf(length[next])) return length[1];
        if (next == 1) return length[1];
        done[next] = true;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (done[i]) continue;
            const bool blocked = std::any_of(closed.begin(), closed.end(), [&](const Box& box) {
                return crosses_interior(nodes[next], nodes[i], box);
            });
            if (blocked) continue;
            const double step = std::hypot(nodes[i].x - nodes[next].x, nodes[i].y - nodes[next].y);
            length[i] = std::min(length[i], length[next] + step);
        }
    }
}

}  // namespace asv::test
