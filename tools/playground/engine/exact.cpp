// The exact predicates without CGAL, whose interval arithmetic needs rounding modes, which
// WebAssembly lacks.

#include "geometry/predicates/exact.hpp"

#include <boost/multiprecision/cpp_int.hpp>

namespace asv::geometry::exact {

int orientation(const Point& a, const Point& b, const Point& c) noexcept {
    using Number = boost::multiprecision::cpp_rational;
    const Number ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
    const Number determinant = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
    return determinant.sign();
}

}  // namespace asv::geometry::exact
