#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/search/search_result.hpp"
#include "core/space/metric.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "core/space/steering/constrained_step.hpp"
#include "core/space/steering/slide_options.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// Slide and pull: motions that give way to whatever stands against them. Every state is kept,
/// since a straight line between the ends of a slide would cut corners.
/// Holds scratch memory: one object for each thread.
class SlideSteering {
  public:
    SlideSteering(MotionChecker& checker, const Metric& metric, const SlideOptions& options);

    /// From a valid row toward a target row: straight as far as that is free, then by constrained
    /// steps, each the projection of the wanted one onto what is near. Appends to visited.
    /// Precondition: the headings of both are unwrapped alike.
    Steered slide(std::span<const double> from, std::span<const double> target,
                  Configurations& visited);

    /// Drags one ASV to a point of the plane with the least motion of the rest.
    Steered pull(std::span<const double> from, std::size_t asv, const geometry::Point& target,
                 Configurations& visited);

    std::uint64_t steps() const { return steps_; }

  private:
    struct Pace {
        double step, margin;
    };
    enum class StepTaken { yes, no, stuck };
    StepTaken take_step(double gained, double length, Pace& pace, Configurations& visited);
    bool tighten(Pace& pace) const;
    bool go_straight(std::span<const double> target, double distance, Configurations& visited);
    void keep(Configurations& visited);

    MotionChecker& checker_;
    const Metric& metric_;
    SlideOptions options_;
    ConstrainedStep constrained_;
    std::vector<double> row_, next_, wish_;
    std::uint64_t steps_ = 0;
};

}  // namespace asv::core
