#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/space/proof/obstacle_field.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// The obstacles of a world as a planner keeps clear of them wherever start and goal are far enough
/// away: each grown by the whole margin, behind their broad phase. What is thinner than the
/// tolerance on each side has vanished. Immutable, shared by all queries of the world.
class KeptObstacles {
  public:
    /// All lengths in the units of the obstacles.
    KeptObstacles(std::span<const geometry::Box> obstacles, double tolerance, double margin);

    const ObstacleField& field() const { return field_; }
    /// Of each box of the field: the index of its obstacle in the world. Ascending.
    const std::vector<std::uint32_t>& numbers() const { return numbers_; }

  private:
    std::vector<std::uint32_t> numbers_;
    ObstacleField field_;
};

/// Those that were prepared, where their boxes are the given ones; else a field of these.
std::shared_ptr<const ObstacleField> field_of(std::span<const geometry::Box> boxes,
                                              std::shared_ptr<const KeptObstacles> prepared);

}  // namespace asv::core
