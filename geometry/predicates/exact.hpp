#pragma once

#include "geometry/primitives.hpp"

/// The slow halves of the predicates: the same questions answered in exact arithmetic alone. The
/// filtered predicates call these when rounding could change their answer; nobody else needs to.

namespace asv::geometry::exact {

/// As geometry::orientation, a thousand times slower. Running out of memory ends the program.
int orientation(const Point& a, const Point& b, const Point& c) noexcept;

}  // namespace asv::geometry::exact
