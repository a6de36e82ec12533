#pragma once

#include <optional>
#include <vector>

#include "core/bounds/walls.hpp"
#include "core/model/problem.hpp"
#include "geometry/primitives.hpp"

/// The tolerance shrinks every obstacle and widens the bounds, and so opens gaps of about two
/// tolerances between obstacles that touch. Whether a chain can follow through such a gap decides
/// what can be said about where its ASVs can go.

namespace asv::core {

/// What an ASV on its own can meet, after shrinking.
struct ShrunkObstacles {
    std::vector<Box> boxes;  ///< the obstacles; each has an interior
    Box bounds;              ///< where an ASV may be, tolerance included
};

/// The place between two shrunk obstacles, or one of them and the outside of the bounds, that
/// before touch, overlap or are at most the tolerance apart (in x and in y).
struct Seam {
    Box gap;           ///< the rectangle between the two; a square where only corners meet
    double width = 0;  ///< distance of the two where shrunk by the tolerance alone
    double depth = 0;  ///< for how long the two run side by side; 0 where only corners meet
};

/// Shrinks every side of the obstacles by slightly more than `shrink`, that of the bounds by
/// slightly more than the tolerance, so that no rounding makes an obstacle too large. Boxes that
/// vanish are left out. Precondition: shrink >= the tolerance.
ShrunkObstacles shrink_obstacles(const Problem& problem, double shrink);

/// The seam between two walls, each shrunk, of which the first is to the left of the other, where
/// they are near enough.
std::optional<Seam> vertical_seam(const Wall& left, const Wall& right, double tolerance);

/// All seams, in no particular order, some of them twice. O(m log m) and the number of pairs of
/// obstacles of which one ends where the other begins, in x or in y.
std::vector<Seam> find_seams(const Problem& problem, double shrink);

/// Is it proven that no chain of the problem can pass through the seam from one end to the other,
/// in primitive steps that the validator accepts? False where nothing is known.
///
/// Proof, for three ASVs or more; b is the length of a broom and e the tolerance. Let ASV j, in the
/// middle of the chain, be half way through the gap, hence in the state before or after it within
/// half a step of that. A broom that has a twentieth of its length inside the gap is steep: within
/// the angle phi = asin(20 width / b) of the gap's direction. That holds for the brooms on both
/// sides of j, for as many in a row as fit between j and this margin, and one more.
/// - If two of them fold back, the polygon turns by at least pi - 2 phi there. All turns have one
///   sign, those below e aside, and sum up to 2 pi. So the headings of all sides lie in a half
///   plane widened by eps = 2 phi + n e; since the sides sum up to zero, they are steep, and the
///   area is at most 2 l^2 sin(eps), where l is the greatest length of the chain.
/// - Otherwise these q brooms lead along a chord of at most s, q times the greatest length of a
///   broom. Whatever way the rest of the chain, at most l - s long, goes on from both ends of the
///   chord, the area is at most (l^2 - s^2) / 4: the integral of |r x dr| / 2, r from one end of
///   the chord. The brooms and the chord enclose at most s^2 tan(phi) / 4 more.
/// If both are less than the area that is required, j never gets there. The paths of the others can
/// be deformed into that of j along the brooms of the start, of the goal, and in between: so no
/// shortest path among them needs the seam, if no broom of start or goal lies in it.
bool is_impassable(const Seam& seam, const Problem& problem);

}  // namespace asv::core
