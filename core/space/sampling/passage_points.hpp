#pragma once

#include <optional>

#include "core/search/rng.hpp"
#include "core/space/proof/obstacle_field.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// Draws points of the plane that lie in a passage, by the bridge test (Hsu, Jiang, Reif and Sun,
/// 2003): both ends of a short bridge lie in obstacles or outside the bounds, its middle is free.
/// One end starts on the side of a box, which finds bridges where boxes are thin as well.
std::optional<geometry::Point> passage_point(const ObstacleField& field,
                                             const geometry::Box& bounds, Rng& rng);

/// A uniform free point, if one is found in some tries.
std::optional<geometry::Point> free_point(const ObstacleField& field, const geometry::Box& bounds,
                                          Rng& rng);

}  // namespace asv::core
