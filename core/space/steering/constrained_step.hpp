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

/// The step nearest to a wished one among those that keep all near requirements:
///
///     minimise |y - wish|^2  subject to  G y >= b
///
/// in the metric's scaled coordinates. The rows of G are the gradients of the near constraints
/// (broom against box, ASV against bounds, turns, closing turns, closing length, area). What the
/// constraints bend over the step is measured at its end and put into b, then the step is solved
/// for once more (the second-order correction of sequential quadratic programming).
class ConstrainedStep {
  public:
    ConstrainedStep(const Chain& chain, const ChainConstraints& constraints,
                    const ObstacleField& field, const Metric& metric);

    /// Collects the constraints that a step of the given length from row can violate. margin is the
    /// gap that is kept to obstacles and bounds where there is that much; where there is less, the
    /// gap is not made smaller. strictness in [0, 1] scales the margins of shape and area.
    void linearise(std::span<const double> row, double step_length, double margin,
                   double strictness);

    /// Asks, as a spring, that an ASV moves by (dx, dy). Call after linearise().
    void pull(std::size_t asv, double dx, double dy, double stiffness);

    /// The configuration that the step nearest to the wish leads to; the wish in scaled
    /// coordinates. Valid until the next call.
    std::span<const double> solve(std::span<const double> wish);

    /// Did a constraint push back in the last solve()?
    bool pushed() const { return program_.pushed(); }

  private:
    /// A constraint gap(configuration) >= 0 that is near.
    struct Near {
        enum class Kind { turn, point, corner, first_turn, last_turn, area, closing } kind;
        std::size_t index = 0;  ///< broom, or turn
        double fraction = 0;    ///< point: where on the broom
        double nx = 0, ny = 0;  ///< point: axis away from what is near; corner: where it is
        double offset = 0;  ///< point: where along the axis that ends; corner: side of the broom
        double gap = 0;     ///< at the row of linearise()
        double change = 0;  ///< how much the gap may change at least
    };

    void add(Near near, double margin, double reach);
    double gap(const Near& near, const Pose& pose, std::span<const double> row) const;
    void gradient(const Near& near, std::span<double> row);
    void from_heading_gradient(std::span<double> row) const;
    void point_gradient(std::size_t broom, double fraction, double nx, double ny,
                        std::span<double> row);
    void closing_turn_gradient(std::size_t end, double sign);
    void area_gradient();
    void closing_gradient();
    void near_boxes(double step_length, double margin);
    void near_box(std::size_t broom, const geometry::Box& box, double step_length, double margin);
    void near_bounds(double step_length, double margin);
    void near_shape(double step_length, double strictness);
    void take(std::span<const double> step);
    bool correct(std::span<const double> step);

    const Chain& chain_;
    const ChainConstraints& constraints_;
    const ObstacleField& field_;
    const Metric& metric_;
    std::vector<double> row_, next_;
    Pose pose_, next_pose_;
    std::vector<double> heading_gradient_;
    std::vector<Near> near_;  ///< one for each row of the program; springs come behind them
    DualActiveSet program_;
};

}  // namespace asv::core
