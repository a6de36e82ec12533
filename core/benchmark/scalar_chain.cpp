#include "core/benchmark/scalar_chain.hpp"

#include <cmath>

#include "geometry/predicates/polygon.hpp"
#include "geometry/predicates/segment_box.hpp"

namespace asv::core::reference {

namespace {

bool turns_valid(std::span<const double> headings, const batch::ChainLimits& limits) {
    for (std::size_t k = 1; k < headings.size(); ++k) {
        const double turn = headings[k] - headings[k - 1];
        if (!(turn >= limits.min_turn[k - 1] && turn <= limits.max_turn)) return false;
    }
    return headings.back() - headings.front() <= limits.max_total_turn;
}

bool closing_valid(std::span<const Point> points, const batch::ChainLimits& limits) {
    const std::size_t n = points.size();
    const auto minus = [](const Point& p, const Point& q) { return Point{p.x - q.x, p.y - q.y}; };
    const auto cross = [](const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; };
    const Point closing = minus(points[0], points[n - 1]);
    const Point first = minus(points[1], points[0]);
    const Point last = minus(points[n - 1], points[n - 2]);
    return cross(last, closing) >= limits.min_last_closing_turn * limits.link &&
           cross(closing, first) >= limits.min_first_closing_turn * limits.link &&
           closing.x * closing.x + closing.y * closing.y >=
               limits.min_closing_side * limits.min_closing_side;
}

}  // namespace

void positions(std::span<const double> row, double link, std::span<Point> points) {
    points[0] = {row[0], row[1]};
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        points[k + 1] = {points[k].x + link * std::cos(row[2 + k]),
                         points[k].y + link * std::sin(row[2 + k])};
    }
}

bool shape_valid(std::span<const double> row, std::span<const Point> points,
                 const batch::ChainLimits& limits) {
    for (const Point& point : points) {
        if (!contains(limits.bounds, point)) return false;
    }
    return turns_valid(row.subspan(2), limits) && closing_valid(points, limits) &&
           signed_area(points) >= limits.min_area;
}

bool meets_any(std::span<const Point> points, std::span<const Box> boxes) {
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const Segment link{points[k], points[k + 1]};
        const Box region = geometry::bounds(link);
        for (const Box& box : boxes) {
            if (overlap(region, box) && meets(link, box)) return true;
        }
    }
    return false;
}

bool valid(std::span<const double> row, const batch::ChainLimits& limits,
           std::span<const Box> boxes, std::span<Point> scratch) {
    positions(row, limits.link, scratch);
    return shape_valid(row, scratch, limits) && !meets_any(scratch, boxes);
}

}  // namespace asv::core::reference
