#pragma once

#include <algorithm>
#include <cstddef>

namespace asv::core {

/// Extension 1: the trees change roles only after a number of steps of their connect loops, counted
/// over as many connects as it takes. A growth across open space uses up its share at once, one in
/// a narrow place keeps its turn for many tries.
///
/// A growth that is one proven motion instead of steps counts as many steps as it is long, and a
/// blocked one as one. Where a space goes by SingleSteps, the steps themselves count.
class SwapLimiter {
  public:
    /// steps: after which the roles change; 0: after each iteration.
    /// step: its length, in the metric.
    SwapLimiter(std::size_t steps, double step) : limit_(steps), step_(step) {}

    /// Tells of a growth of so great a length.
    void grown(double length) { steps_ += std::max(1.0, length / step_); }

    /// Tells of a growth of so many steps, the one that was blocked included.
    void stepped(std::size_t steps) { steps_ += static_cast<double>(steps); }

    /// Is it time to swap? Then counting starts again.
    bool due() {
        if (steps_ < static_cast<double>(limit_)) return false;
        steps_ = 0;
        return true;
    }

  private:
    std::size_t limit_;
    double step_, steps_ = 0;
};

}  // namespace asv::core
