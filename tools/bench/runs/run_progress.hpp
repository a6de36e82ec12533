#pragma once

#include <cstddef>
#include <string>

#include "core/benchmark/run.hpp"
#include "tools/common/progress_line.hpp"

namespace asv::tools {

/// Shows which run of a benchmark is at work, and how long all of them may take.
class RunProgress {
  public:
    /// Of so many runs of the plan. Precondition: the plan outlives this.
    RunProgress(const core::BenchmarkPlan& plan, std::size_t runs, bool wanted)
        : plan_(plan), runs_(runs), line_(wanted) {}

    void begin(const core::RunPlace& place);
    void end() { ++done_; }
    /// A line that stays, on standard error.
    void tell(const std::string& text);

  private:
    const core::BenchmarkPlan& plan_;
    std::size_t runs_;
    ProgressLine line_;
    core::Clock::time_point begun_ = core::Clock::now();
    std::size_t done_ = 0;
};

}  // namespace asv::tools
