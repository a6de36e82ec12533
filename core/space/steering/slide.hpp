#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "asv/core/planning/result.hpp"
#include "asv/core/space/metric.hpp"
#include "asv/core/space/motion.hpp"
#include "asv/core/space/steering/constrained_step.hpp"
#include "asv/geometry/primitives.hpp"

namespace asv::core {

/// Settings of the steering that follows the requirements instead of stopping at them.
struct SlideOptions {
    bool slide = true;       ///< off: straight motions only, stopped by what they meet
    double step = 0.03;      ///< longest constrained step, root mean square motion of the ASVs
    double margin = 0.002;   ///< gap kept to obstacles where there is room
    double hair = 5e-6;      ///< least gap, where the place is so tight that the margin closes it
    double progress = 0.05;  ///< share of its step by which a step has to come nearer
    std::size_t most_steps = 200;  ///< of one call
};

/// Slide and pull: motions that give way to whatever stands against them. Every state is kept,
/// since a straight line between the ends of a slide would cut corners.
/// Holds scratch memory: one object for each thread.
class SlideSteering {
  public:
    SlideSteering(MotionChecker& checker, const Metric& metric, const SlideOptions& options);

    /// From a valid row toward a target row: straight as far as that is free, then by constrained
    /// steps, each the projection of the wanted one onto what is near. Appends to visited.
    /// Precondition: the headings of both are unwrapped alike.
    Steered slide(std::span<const double> from, std::span<const double> target, Rows& visited);

    /// Drags one ASV to a point of the plane with the least motion of the rest.
    Steered pull(std::span<const double> from, std::size_t asv, const geometry::Point& target,
                 Rows& visited);

    std::uint64_t steps() const { return steps_; }

  private:
    struct Pace {
        double step, margin;
    };
    enum class StepTaken { yes, no, stuck };
    StepTaken take_step(double gained, double length, Pace& pace, Rows& visited);
    bool tighten(Pace& pace) const;
    bool go_straight(std::span<const double> target, double distance, Rows& visited);
    void keep(Rows& visited);

    MotionChecker& checker_;
    const Metric& metric_;
    SlideOptions options_;
    ConstrainedStep constrained_;
    std::vector<double> row_, next_, wish_;
    std::uint64_t steps_ = 0;
};

}  // namespace asv::core
