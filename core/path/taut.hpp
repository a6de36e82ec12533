#pragma once

#include <span>
#include <vector>

#include "asv/core/path/motion_cost.hpp"
#include "asv/core/planning/result.hpp"
#include "asv/core/space/metric.hpp"
#include "asv/core/space/motion.hpp"
#include "asv/core/space/steering/constrained_step.hpp"

namespace asv::core {

/// Pulls a path taut like an elastic band (Quinlan and Khatib, 1993) under the requirements: every
/// way point in turn takes a constrained step down the gradient of the cost of its two motions, and
/// keeps it where both stay proven and the cost falls. Holds scratch memory.
class TautPuller {
  public:
    TautPuller(MotionChecker& checker, const Metric& metric);

    /// Puts way points into the path so that no motion is longer than spacing (in the metric).
    Rows resample(const Rows& path, double spacing) const;

    /// One sweep over all way points of the path, back and forth; returns by how much the cost
    /// fell.
    double sweep(Rows& path);

    /// Takes way points out where the straight motion past them is proven and costs no more.
    void simplify(Rows& path);

    std::size_t steps() const { return steps_; }

  private:
    std::span<double> row(Rows& path, std::size_t index) const {
        return {path.data() + index * dimension_, dimension_};
    }
    double improve(Rows& path, std::size_t index);
    double downhill(std::span<const double> before, std::span<const double> here,
                    std::span<const double> behind);

    MotionChecker& checker_;
    const Metric& metric_;
    std::size_t dimension_;
    ConstrainedStep constrained_;
    MotionCost cost_;
    Pose before_, here_, behind_;
    std::vector<double> wish_, candidate_, heading_gradient_;
    std::size_t steps_ = 0;
};

}  // namespace asv::core
