#include "tests/kit/geometry/exact_oracle.hpp"

#include <algorithm>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace asv::test {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

namespace {

using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Kernel>
typename Kernel::Point_2 to(const Point& p) {
    return {typename Kernel::FT(p.x), typename Kernel::FT(p.y)};
}

}  // namespace

int exact_orientation(const Point& a, const Point& b, const Point& c) {
    return static_cast<int>(CGAL::orientation(to<Rational>(a), to<Rational>(b), to<Rational>(c)));
}

bool exact_meets(const Segment& segment, const Box& box) {
    const Filtered::Iso_rectangle_2 rectangle(to<Filtered>(box.low), to<Filtered>(box.high));
    // CGAL divides by the length of the segment.
    if (segment.a == segment.b) return !rectangle.has_on_unbounded_side(to<Filtered>(segment.a));
    return CGAL::do_intersect(Filtered::Segment_2(to<Filtered>(segment.a), to<Filtered>(segment.b)),
                              rectangle);
}

double exact_squared_distance(const Segment& segment, const Box& box) {
    if (exact_meets(segment, box)) return 0;
    const auto corner = [](double x, double y) { return to<Rational>(Point{x, y}); };
    const Rational::Point_2 corners[] = {
        corner(box.low.x, box.low.y), corner(box.high.x, box.low.y), corner(box.high.x, box.high.y),
        corner(box.low.x, box.high.y)};
    const Rational::Segment_2 ours(to<Rational>(segment.a), to<Rational>(segment.b));
    auto nearest = CGAL::squared_distance(ours.source(), corners[0]);
    const auto consider = [&](const Rational::Point_2& point, const Rational::Segment_2& other) {
        nearest =
            std::min(nearest, other.is_degenerate() ? CGAL::squared_distance(point, other.source())
                                                    : CGAL::squared_distance(point, other));
    };
    for (int i = 0; i < 4; ++i) {
        const Rational::Segment_2 side(corners[i], corners[(i + 1) % 4]);
        consider(corners[i], ours);
        consider(ours.source(), side);
        consider(ours.target(), side);
    }
    return CGAL::to_double(nearest);
}

}  // namespace asv::test
