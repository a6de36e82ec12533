#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/model/problem.hpp"

/// Corridors that no chain of a problem gets through, since it would have to lie between the walls
/// as a whole and has no room there for its area.

namespace asv::core {

struct LowCorridor {
    /// Across the corridor, from wall to wall: where the middle of the chain cannot be, whatever
    /// primitive steps the validator accepts. It reaches into both walls.
    Box closed;
    /// The obstacles below and above, or left and right of it, from 0; none for the outside of the
    /// bounds.
    std::array<std::optional<std::size_t>, 2> walls;
    double height = 0;     ///< how far apart they are; 0 or less where they touch or overlap
    bool upright = false;  ///< the walls are left and right
};

/// The middle of the arc: an ASV, or the middle of a broom. Precondition: not empty.
Point middle_of_chain(const std::vector<Point>& state);

/// All straight corridors between two obstacles, or one of them and the outside of the bounds, that
/// are longer than the chain and too low for it; others may stand in them.
///
/// Proof, with e the tolerance, s = max_step + e the farthest that an ASV gets in a step, and half
/// the length of half a chain of brooms that are e too long. The walls, shrunk by e, meet no broom,
/// and both are thicker than s. If the middle of the chain got past `closed`, it would be in one of
/// two successive states within s / 2 of it, hence between the walls (being no farther than that
/// from a place between them, and not inside of them) and half or more from both mouths. So all of
/// the chain would be in the strip between the walls, since it leaves it only through a mouth. Its
/// area would be at most max_area_between_walls(), which is less than what is required.
///
/// Not all that are found need to be in anybody's way.
///
/// Empty for other bodies than chains, and for one or two ASVs. O(m log m) and the number of pairs
/// of long obstacles that are near enough to each other. Precondition: the problem has bounds.
std::vector<LowCorridor> find_low_corridors(const Problem& problem);

/// What LowCorridor tells of its walls: "between obstacles 2 and 3", "between obstacle 4 and the
/// upper border".
std::string place_of(const std::array<std::optional<std::size_t>, 2>& walls, bool upright);

/// One sentence that names the corridors, with numbers from 1, and the height that is needed at
/// least: "no chain of 7 ASVs passes the corridor between obstacles 2 and 3: it is 0.0213 high, and
/// 0.022576 is needed". Precondition: there are some, all higher than 0.
std::string describe(const std::vector<LowCorridor>& corridors, const Problem& problem);

}  // namespace asv::core
