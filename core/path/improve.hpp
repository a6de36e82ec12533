#pragma once

#include <cstdint>
#include <functional>

#include "asv/core/planning/limits.hpp"
#include "asv/core/planning/result.hpp"
#include "asv/core/planning/rng.hpp"
#include "asv/core/space/steering/slide.hpp"

namespace asv::core {

/// Shortens a path by shortcuts, straight and sliding ones, of all lengths, until the work is spent
/// or nothing more is gained. Work is counted, not timed, so that the same seed gives the same path
/// on every machine: one unit is about a microsecond. The limits end it early.
/// Returns the better path; on_better is told the cost of each.
Rows improve(Rows path, MotionChecker& checker, SlideSteering& steering, double work,
             const Limits& limits, Rng& rng, const std::function<void(double)>& on_better = {});

}  // namespace asv::core
