#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/space/metric.hpp"
#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/obstacle_field.hpp"
#include "core/space/steering/dual_active_set.hpp"
#include "core/space/steering/near_constraints.hpp"

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
    /// A constraint of the program; springs come behind them.
    struct Heeded {
        NearConstraint near;
        double gap;     ///< at the row of linearise()
        double change;  ///< how much the gap may change at least
    };

    void heed(const NearConstraint& near, double margin, double step_length);
    void to_scaled(std::span<const double> gradient, std::span<double> row) const;
    void take(std::span<const double> step);
    bool correct(std::span<const double> step);

    const Chain& chain_;
    const ChainConstraints& constraints_;
    const Metric& metric_;
    NearConstraints near_;
    std::vector<double> row_, next_, gradient_;
    Pose pose_, next_pose_;
    std::vector<Heeded> heeded_;
    DualActiveSet program_;
};

}  // namespace asv::core
