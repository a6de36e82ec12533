#pragma once

#include "core/solve/stages/solve_call.hpp"

namespace asv::core {

/// Passes progress on to the caller's observer, some ten times a second at most. For one thread.
class ProgressReport {
  public:
    /// The call has to outlive the report.
    explicit ProgressReport(const SolveCall& call) : call_(call) {}

    /// cost: of the best path, in the given units, once there is one.
    void tell(const Progress& search, std::optional<double> cost) {
        if (!call_.options.on_progress) return;
        const double elapsed = call_.clock.elapsed();
        if (elapsed - last_ < spacing) return;
        last_ = elapsed;
        call_.options.on_progress({search, cost, elapsed});
    }

  private:
    static constexpr double spacing = 0.1;  // seconds

    const SolveCall& call_;
    double last_ = 0;
};

}  // namespace asv::core
