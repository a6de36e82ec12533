#include "core/space/sampling/passage_points.hpp"

#include <algorithm>

namespace asv::core {

using geometry::Box;
using geometry::Point;

namespace {

constexpr int tries = 30;
/// Standard deviation of a bridge's length, in shares of the field's greater side.
constexpr double bridge_share = 0.1;

bool inside(const Box& box, const Point& p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

Point on_boundary(const Box& box, Rng& rng) {
    const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
    const double along = rng.uniform(0, width + height);
    const bool far_side = rng.chance(0.5);
    if (along < width) return {box.low.x + along, far_side ? box.high.y : box.low.y};
    return {far_side ? box.high.x : box.low.x, box.low.y + along - width};
}

}  // namespace

std::optional<Point> passage_point(const ObstacleField& field, const Box& bounds, Rng& rng) {
    if (field.boxes().empty()) return std::nullopt;
    const double deviation =
        bridge_share * std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
    for (int attempt = 0; attempt < tries; ++attempt) {
        const Point a = on_boundary(field.boxes()[rng.below(field.boxes().size())], rng);
        const Point b{a.x + deviation * rng.normal(), a.y + deviation * rng.normal()};
        if (!inside(bounds, a)) continue;
        if (inside(bounds, b) && !field.contains(b)) continue;
        const Point middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
        if (inside(bounds, middle) && !field.contains(middle)) return middle;
    }
    return std::nullopt;
}

std::optional<Point> free_point(const ObstacleField& field, const Box& bounds, Rng& rng) {
    for (int attempt = 0; attempt < tries; ++attempt) {
        const Point p{rng.uniform(bounds.low.x, bounds.high.x),
                      rng.uniform(bounds.low.y, bounds.high.y)};
        if (!field.contains(p)) return p;
    }
    return std::nullopt;
}

}  // namespace asv::core
