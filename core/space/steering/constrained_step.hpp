#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "asv/core/chain/chain.hpp"
#include "asv/core/space/chain_constraints.hpp"
#include "asv/core/space/metric.hpp"
#include "asv/core/space/obstacle_field.hpp"
#include "asv/core/space/steering/dual_active_set.hpp"

namespace asv::core {

/// The step nearest to a wished one among those that keep all near requirements, to first order:
///
///     minimise |y - wish|^2  subject to  G y >= b
///
/// in the metric's scaled coordinates. The rows of G are the gradients of the near constraints
/// (broom against box, ASV against bounds, turns, closing turns, closing length, area).
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
    std::span<const double> solve(std::span<const double> wish) { return program_.solve(wish); }

    /// Did a constraint push back in the last solve()?
    bool pushed() const { return program_.pushed(); }
    /// The pose at the row of the last linearise().
    const Pose& pose() const { return pose_; }

  private:
    void keep(double limit, double reach, std::span<const double> row);
    void point_row(std::size_t broom, double fraction, double nx, double ny, std::span<double> row);
    void from_heading_gradient(std::span<double> row);
    void keep_point(std::size_t broom, double fraction, double nx, double ny, double limit,
                    double reach);
    void keep_shape(double limit, double reach);
    void near_turns(std::span<const double> configuration, double step_length);
    void near_boxes(double step_length, double margin);
    void near_box(std::size_t broom, const geometry::Box& box, double step_length, double margin);
    void near_bounds(double step_length, double margin);
    void near_shape(double step_length, double strictness);

    const Chain& chain_;
    const ChainConstraints& constraints_;
    const ObstacleField& field_;
    const Metric& metric_;
    Pose pose_;
    NearBoxes near_;
    std::vector<double> heading_gradient_;
    DualActiveSet program_;
};

}  // namespace asv::core
