#include "geometry/predicates/exact.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace asv::geometry::exact {

int orientation(const Point& a, const Point& b, const Point& c) noexcept {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto cgal = [](const Point& p) { return Kernel::Point_2(p.x, p.y); };
    return static_cast<int>(Kernel().orientation_2_object()(cgal(a), cgal(b), cgal(c)));
}

}  // namespace asv::geometry::exact
