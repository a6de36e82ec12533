#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/validation/box_tree.hpp"
#include "core/validation/finding.hpp"
#include "core/validation/state_checks.hpp"

namespace asv::core::validation {

/// The obstacles, shrunk by the tolerance on each side; what is thinner than that has vanished.
class Obstacles {
  public:
    Obstacles(std::span<const geometry::Box> boxes, double tolerance);

    /// No broom meets an obstacle; decided exactly. Room: the distance between the two, negated
    /// the least shift that would part them. Pairs with room of at least `radius` are passed over
    /// (a finding without any pair has infinite room). Precondition: finite coordinates.
    Finding check(State state, double radius) const;

    /// The same for a point that moves straight: no obstacle meets the segment, which may be a
    /// point as well.
    Finding check_point(const geometry::Segment& motion, double radius) const;

    const BoxTree& tree() const { return tree_; }

  private:
    BoxTree tree_;
};

/// How far the segment has to be shifted at least to leave the box. Precondition: they meet.
double penetration(const geometry::Segment& segment, const geometry::Box& box);

/// The distance when they do not meet, minus the penetration when they do; ok in the first case.
Finding clearance(const geometry::Segment& segment, const geometry::Box& box);

}  // namespace asv::core::validation
