#pragma once

#include "geometry/primitives.hpp"

/// The answers of CGAL's exact kernels, to test ours against.

namespace asv::geometry::oracle {

/// Sign of the triangle's area in rational arithmetic.
int orientation(const Point& a, const Point& b, const Point& c);

/// CGAL::do_intersect on the exact-predicates kernel. Precondition: box is not empty.
bool meets(const Segment& segment, const Box& box);

/// The squared distance in rational arithmetic, rounded once to double at the end.
double squared_distance(const Segment& segment, const Box& box);

}  // namespace asv::geometry::oracle
