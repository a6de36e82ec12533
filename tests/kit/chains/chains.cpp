#include "tests/kit/chains/chains.hpp"

#include <algorithm>
#include <cmath>

namespace asv::test {

Points chain_with_turns(Point first, double heading, std::span<const double> turns) {
    Points chain{first};
    for (std::size_t i = 0; i <= turns.size(); ++i) {
        if (i > 0) heading += turns[i - 1];
        const Point& last = chain.back();
        chain.push_back({last.x + 0.05 * std::cos(heading), last.y + 0.05 * std::sin(heading)});
    }
    return chain;
}

Points chain_with_turns(Point first, double heading, std::initializer_list<double> turns) {
    return chain_with_turns(first, heading, std::span(turns.begin(), turns.size()));
}

Points arc(std::size_t n, Point first, double heading, double turn) {
    if (n == 1) return {first};
    return chain_with_turns(first, heading, std::vector<double>(n - 2, turn));
}

Points ring(std::size_t n, Point centroid, double heading, double closing) {
    const double turn = closing * 2 * std::numbers::pi / static_cast<double>(n);
    const Points points = arc(n, {0, 0}, heading, turn);
    double x = 0, y = 0;
    for (const Point& p : points) {
        x += p.x / static_cast<double>(n);
        y += p.y / static_cast<double>(n);
    }
    return moved(points, centroid.x - x, centroid.y - y);
}

Points corner() {
    return {{0.5, 0.5}, {0.55, 0.5}, {0.55, 0.55}};
}

Points moved(Points points, double dx, double dy) {
    for (Point& p : points) p = {p.x + dx, p.y + dy};
    return points;
}

Points reversed(Points points) {
    std::reverse(points.begin(), points.end());
    return points;
}

double farthest_move(std::span<const Point> from, std::span<const Point> to) {
    double most = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        most = std::max(most, std::hypot(from[i].x - to[i].x, from[i].y - to[i].y));
    return most;
}

}  // namespace asv::test
