#pragma once

#include <cstddef>
#include <vector>

#include "core/model/body.hpp"
#include "core/model/requirements.hpp"
#include "core/validation/collisions.hpp"
#include "core/validation/finding.hpp"

namespace asv::core::validation {

/// An arm with a fixed base whose links turn evenly from one set of headings to another.
class ArmMotion {
  public:
    /// Headings from and to in radians, not wrapped; each link turns by their difference.
    ArmMotion(const std::vector<double>& links, const geometry::Point& base,
              std::vector<double> from, std::vector<double> to);

    std::size_t link_count() const { return links_.size(); }
    /// Link i at a time in [0, 1].
    geometry::Segment link(std::size_t i, double t) const;
    /// How far any point of link i moves at most during the whole motion; at least its speed.
    double bound(std::size_t i) const { return bound_[i]; }

  private:
    const std::vector<double>& links_;
    geometry::Point base_;
    std::vector<double> from_, to_, bound_;
};

/// The joints and the tip are in the bounds at every time; holds only when proven.
Finding check_arm_motion_bounds(const ArmMotion& motion, const Requirements& requirements);

/// No link meets an obstacle at any time; holds only when proven: at some time the distance is more
/// than the link can move until the next one. Pairs that keep `radius` are passed over.
Finding check_arm_motion_collisions(const ArmMotion& motion, const Obstacles& obstacles,
                                    double radius);

}  // namespace asv::core::validation
