#pragma once

#include "core/model/path.hpp"
#include "core/solve/solve.hpp"

namespace asv::core {

/// As solve(), but begins with a path of a problem much like this one: obstacles, start or goal
/// have moved a little. What of the last path is still proven valid is kept; its pieces, and the
/// new ends, are joined by steering and, where that is blocked, by short searches of the planner
/// (retrieve and repair: Berenson, Abbeel and Goldberg, 2012). The path is then shortened and
/// checked like every other. Where it cannot be mended, the planner starts from nothing.
///
/// The last path may be that of any problem, valid or not; one of another number of ASVs, or
/// with coordinates that are not finite, is not looked at. Throws what solve() throws.
SolveResult replan(const Problem& problem, const Path& last_path, const SolveOptions& options = {});

}  // namespace asv::core
