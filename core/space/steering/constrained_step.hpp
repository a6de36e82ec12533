#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "asv/core/chain/chain.hpp"
#include "asv/core/space/chain_constraints.hpp"
#include "asv/core/space/metric.hpp"
#include "asv/core/space/obstacle_field.hpp"

namespace asv::core {

/// The step nearest to a wished one among those that keep all near requirements, to first order:
///
///     minimise |y - wish|^2  subject to  G y >= b
///
/// in the metric's scaled coordinates. The rows of G are the gradients of the near constraints
/// (broom against box, ASV against bounds, turns, closing turns, closing length, area); solved in the
/// dual by projected Gauss-Seidel sweeps (Hildreth, 1957).
class ConstrainedStep {
  public:
    ConstrainedStep(const Chain& chain, const ChainConstraints& constraints,
                    const ObstacleField& field, const Metric& metric);

    /// Collects the constraints that a step of the given length from row can violate. margin is the
    /// gap that is kept to obstacles and bounds where there is that much; where there is less, the
    /// gap is not made smaller. strictness in [0, 1] scales the margins of shape and area.
    void linearise(std::span<const double> row, double step_length, double margin,
                   double strictness);

    /// Asks, as a stiff spring, that an ASV moves by (dx, dy). Call after linearise().
    void pull(std::size_t asv, double dx, double dy, double stiffness);

    /// The step for a wish, both in scaled coordinates; valid until the next call.
    std::span<const double> solve(std::span<const double> wish);

    /// Did a constraint push back in the last solve()?
    bool pushed() const { return pushed_; }
    /// The pose at the row of the last linearise().
    const Pose& pose() const { return pose_; }

  private:
    double* add_row(double limit, double compliance = 0);
    void keep_row(double reach);
    void point_row(std::size_t broom, double fraction, double nx, double ny, double* row);
    void from_heading_gradient(double* row);
    void near_boxes(double step_length, double margin);
    void near_bounds(double step_length, double margin);
    void near_shape(double step_length, double strictness);

    const Chain& chain_;
    const ChainConstraints& constraints_;
    const ObstacleField& field_;
    const Metric& metric_;
    Pose pose_;
    NearBoxes near_;
    std::vector<double> heading_gradient_;
    std::size_t row_count_ = 0;
    std::vector<double> rows_;  ///< row_count_ x dimension
    std::vector<double> limit_, norm_, multiplier_, compliance_;
    std::vector<double> turn_limit_, turn_multiplier_;
    std::vector<double> step_;
    bool pushed_ = false;
};

}  // namespace asv::core
