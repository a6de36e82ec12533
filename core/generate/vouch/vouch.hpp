#pragma once

#include <string>
#include <vector>

#include "core/model/problem.hpp"

namespace asv::core {

/// What a conservative check says about a problem.
struct Verdict {
    bool solvable = false;  ///< false: unknown, never "infeasible"
    std::string reason;
    /// Where solvable: way points of a path, as configurations of a Chain anchored at its centroid;
    /// the straight motion between any two neighbours is proven valid. Empty otherwise.
    std::vector<std::vector<double>> way_points;
    /// The way points are those of the chain read from ASV n to ASV 1 (problems that run
    /// clockwise).
    bool reversed = false;
};

/// Tries to build a path from simple motions: the chain is bent to a regular polygon, which moves
/// inside a disc through free space, and it threads straight horizontal corridors between two boxes
/// along the outline of a rectangle. Every motion is proven by MotionChecker, so "solvable" is
/// certain; everything that needs more skill is "unknown", and so is one ASV.
///
/// Precondition: start and goal are valid. Corridors are looked for only where there are at most 64
/// obstacles.
Verdict vouch(const Problem& problem);

}  // namespace asv::core
