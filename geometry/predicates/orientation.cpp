#include "geometry/predicates/orientation.hpp"

#include <cmath>

#include "geometry/predicates/exact.hpp"

namespace asv::geometry {

// With u = 2^-53 and finite intermediate values, each of the four differences carries one rounding
// (they cannot underflow), each product one more, or an absolute error of at most 2^-1075 where it
// underflows. So the computed product p~ of an exact product p satisfies
//     |p~ - p| <= ((1 - u)^-3 - 1) |p~| + 2^-1074 <= (3u + 7u^2) |p~| + 2^-1074.
// The last subtraction errs by at most u |det~|, and det~ has the sign of the exact determinant
// when
//     |det~| (1 - u) > (3u + 7u^2) (|left| + |right|) + 2^-1073.
// The right-hand side is evaluated with three more roundings; (3 + 16u) u and the smallest normal
// number swallow those and the factor 1 - u. Where a product overflows, the bound does too or is
// NaN, and the comparison is false.
int orientation(const Point& a, const Point& b, const Point& c) noexcept {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    const double error = orientation_filter.relative * (std::fabs(left) + std::fabs(right)) +
                         orientation_filter.absolute;
    if (determinant > error) return 1;
    if (-determinant > error) return -1;
    return exact::orientation(a, b, c);
}

}  // namespace asv::geometry
