#pragma once

#include "core/model/problem.hpp"

namespace asv::core {

/// The part of the plane in which to look for a path: the bounds where there are any; else what an
/// arm can reach, or a rectangle around start, goal and obstacles with room for the body to pass
/// them on every side. Finite, and no shortest path of a point leaves it.
Box planning_window(const Problem& problem);

/// The problem with its planning window for bounds.
Problem bounded(Problem problem);

}  // namespace asv::core
