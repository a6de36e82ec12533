#include "tests/kit/geometry/adversary.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace asv::test {

using geometry::Box;
using geometry::Point;

namespace {

Point times(const Point& p, double factor) {
    return {p.x * factor, p.y * factor};
}

Point along(const Point& from, const Point& direction, double t) {
    return {from.x + t * direction.x, from.y + t * direction.y};
}

Box hull(const Point& p, const Point& q) {
    return geometry::bounds(geometry::Segment{p, q});
}

}  // namespace

double Adversary::nudged(double value) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    switch (pick(4)) {
        case 0:
            return std::nextafter(value, infinity);
        case 1:
            return std::nextafter(value, -infinity);
        default:
            return value;
    }
}

Point Adversary::nudged(const Point& point) {
    return {nudged(point.x), nudged(point.y)};
}

double Adversary::scale() {
    switch (pick(8)) {
        case 0:
            return std::ldexp(1, -1040 - pick(30));  // subnormal coordinates
        case 1:
            return std::ldexp(1, -500 - pick(100));  // products underflow
        case 2:
            return std::ldexp(1, 450 + pick(560));  // products overflow, then differences
        case 3:
            return std::ldexp(1, pick(60) - 30);
        default:
            return 1;
    }
}

Adversary::Pair Adversary::plain_pair() {
    const auto point = [this] { return Point{uniform(-1, 1), uniform(-1, 1)}; };
    return {{point(), point()}, hull(point(), point())};
}

Adversary::Pair Adversary::lattice_pair() {
    const auto point = [this] {
        return Point{static_cast<double>(pick(5)), static_cast<double>(pick(5))};
    };
    return {{point(), point()}, hull(point(), point())};
}

Adversary::Pair Adversary::corner_pair() {
    const Box box = plain_pair().box;
    const Point corner{pick(2) == 0 ? box.low.x : box.high.x,
                       pick(2) == 0 ? box.low.y : box.high.y};
    const Point direction{uniform(-1, 1), uniform(-1, 1)};
    // Dyadic directions and parameters often hit the corner exactly.
    const Point dyadic{std::round(direction.x * 64) / 64, std::round(direction.y * 64) / 64};
    const Point& d = pick(2) == 0 ? direction : dyadic;
    const double before = pick(2) == 0 ? 0.5 : uniform(0, 1);
    const double after = pick(2) == 0 ? 0.25 : uniform(-0.1, 1);
    return {{nudged(along(corner, d, -before)), nudged(along(corner, d, after))}, box};
}

Adversary::Pair Adversary::side_pair() {
    const Box box = plain_pair().box;
    const double x = pick(2) == 0 ? box.low.x : box.high.x;
    const Point on_side{nudged(x), uniform(box.low.y - 0.1, box.high.y + 0.1)};
    const Point other{pick(2) == 0 ? nudged(x) : uniform(-1, 1), uniform(-1, 1)};
    Pair pair{{on_side, other}, box};
    if (pick(2) == 0) {
        std::swap(pair.segment.a.x, pair.segment.a.y);
        std::swap(pair.segment.b.x, pair.segment.b.y);
        std::swap(pair.box.low.x, pair.box.low.y);
        std::swap(pair.box.high.x, pair.box.high.y);
    }
    return pair;
}

Adversary::Pair Adversary::pair() {
    constexpr Pair (Adversary::*kinds[])() = {&Adversary::plain_pair, &Adversary::lattice_pair,
                                              &Adversary::corner_pair, &Adversary::corner_pair,
                                              &Adversary::side_pair};
    Pair pair = (this->*kinds[pick(5)])();
    if (pick(8) == 0) pair.segment.b = pair.segment.a;
    if (pick(8) == 0) pair.box.high.x = pair.box.low.x;
    if (pick(8) == 0) pair.box.high.y = pair.box.low.y;
    const double factor = scale();
    for (Point* point : {&pair.segment.a, &pair.segment.b, &pair.box.low, &pair.box.high}) {
        *point = times(*point, factor);
    }
    return pair;
}

Adversary::Triple Adversary::triple() {
    const Pair drawn = pair();
    const auto& [a, b] = drawn.segment;
    switch (pick(4)) {
        case 0:
            return {a, b, drawn.box.low};
        case 1:
            return {a, b, nudged(b)};
        default: {
            const double t = std::ldexp(static_cast<double>(pick(17)), -4);
            return {a, b, nudged(Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)})};
        }
    }
}

}  // namespace asv::test
