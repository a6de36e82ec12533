#pragma once

#include <span>

#include "core/search/rng.hpp"
#include "core/space/proof/motion_checker.hpp"

namespace asv::core {

/// Draws valid configurations by drawing the shape alone first: the total turn, split over the
/// joints by a Dirichlet draw (of several concentrations, from a few sharp bends to an even arc),
/// accepted by its area and closing turns; then a place for it until it is free. For many ASVs
/// thousands of times likelier to succeed than joint by joint.
class ShapeSampler {
  public:
    explicit ShapeSampler(MotionChecker& checker);

    /// Fills row with a valid configuration; false when none was found in some hundred tries.
    bool sample(Rng& rng, std::span<double> row);
    /// Fills row with a valid configuration whose ASV in the middle is at the point, give or take a
    /// normally distributed distance; false when none was found in some tries.
    bool sample_near(Rng& rng, const geometry::Point& point, double deviation,
                     std::span<double> row);
    /// Fills the turns of row with those of a valid shape; false after some hundred tries.
    bool sample_shape(Rng& rng, std::span<double> row);
    /// Do the turns of the row meet the requirements that a place does not matter for?
    /// Precondition: at least 3 ASVs.
    bool valid_shape(std::span<const double> row);

  private:
    MotionChecker& checker_;
    Pose pose_;
};

}  // namespace asv::core
