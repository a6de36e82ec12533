#pragma once

#include "geometry/primitives.hpp"

/// The answers of CGAL's exact kernels, to test ours against.

namespace asv::test {

/// Sign of the triangle's area in rational arithmetic.
int exact_orientation(const geometry::Point& a, const geometry::Point& b, const geometry::Point& c);

/// CGAL::do_intersect on the exact-predicates kernel. Precondition: box is not empty.
bool exact_meets(const geometry::Segment& segment, const geometry::Box& box);

/// The squared distance in rational arithmetic, rounded once to double at the end.
double exact_squared_distance(const geometry::Segment& segment, const geometry::Box& box);

}  // namespace asv::test
