#include "geometry/predicates/polygon.hpp"

#include <vector>

#include "geometry/predicates/orientation.hpp"

namespace asv::geometry {

namespace {

bool lexicographically_less(const Point& a, const Point& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

std::vector<Point> without_repetitions(std::span<const Point> polygon) {
    std::vector<Point> points;
    points.reserve(polygon.size());
    for (const Point& point : polygon) {
        if (points.empty() || point != points.back()) points.push_back(point);
    }
    while (points.size() > 1 && points.back() == points.front()) points.pop_back();
    return points;
}

}  // namespace

double signed_area(std::span<const Point> polygon) noexcept {
    double twice = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Point& origin = polygon[0];
        const Point& p = polygon[i - 1];
        const Point& q = polygon[i];
        twice += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
    }
    return twice / 2;
}

// A polygon that always turns to one side is convex when it winds once, that is when its edges
// change only twice between rightward and leftward (vertical ones counting by their sense upward).
// A reversal shows as such a change at a straight vertex; a true change always turns.
int convex_orientation(std::span<const Point> polygon) {
    const std::vector<Point> points = without_repetitions(polygon);
    const std::size_t n = points.size();
    if (n < 3) return 0;
    int sign = 0;
    int changes = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point& a = points[i];
        const Point& b = points[(i + 1) % n];
        const Point& c = points[(i + 2) % n];
        const int turn = orientation(a, b, c);
        const bool changed = lexicographically_less(a, b) != lexicographically_less(b, c);
        if (turn == 0 ? changed : turn == -sign) return 0;
        if (turn != 0) sign = turn;
        if (changed) ++changes;
    }
    return changes == 2 ? sign : 0;
}

}  // namespace asv::geometry
