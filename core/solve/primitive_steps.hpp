#pragma once

#include <optional>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/search/limits.hpp"
#include "core/search/search_result.hpp"
#include "core/space/proof/motion_checker.hpp"

namespace asv::core {

/// Turns a path of configurations into primitive steps: states of which neighbours are as far apart
/// as the limit allows (the fastest ASV moves max_step), from exactly the problem's start to
/// exactly its goal, whose brooms may be off by the rounding of the file.
///
/// A step ends at a way point only where cutting past it cannot be proven valid.
/// Precondition: rows lead from the start to the goal of the problem by proven motions of the
/// checker's chain, which belongs to the problem.
Path primitive_steps(const Problem& problem, const Configurations& rows, MotionChecker& checker);

/// The same; none when the deadline comes first.
std::optional<Path> primitive_steps_before(Clock::time_point deadline, const Problem& problem,
                                           const Configurations& rows, MotionChecker& checker);

}  // namespace asv::core
