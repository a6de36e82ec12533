#pragma once

#include "geometry/primitives.hpp"

namespace asv::geometry {

/// Exact: do the closed segment and the closed box share a point? Touching counts. An empty box
/// meets nothing. Precondition: finite coordinates.
bool meets(const Segment& segment, const Box& box) noexcept;

}  // namespace asv::geometry
