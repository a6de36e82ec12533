#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/search/rng.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// The gaps between obstacles that face each other: each pair of boxes (and of a box and a side of
/// the bounds) whose projections on one axis overlap spans a box between them along the other axis.
/// Only gaps up to the given width are corridors.
class Corridors {
  public:
    Corridors(std::span<const geometry::Box> boxes, const geometry::Box& bounds, double widest);

    std::span<const geometry::Box> gaps() const { return gaps_; }

    /// A uniform point of a random gap; none when there is no gap. It may lie in a third obstacle.
    std::optional<geometry::Point> sample(Rng& rng) const;

  private:
    std::vector<geometry::Box> gaps_;
};

}  // namespace asv::core
