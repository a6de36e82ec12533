#pragma once

#include <optional>
#include <vector>

#include "io/benchmark/report.hpp"
#include "tools/bench/records/journal.hpp"

namespace asv::tools {

/// How a sweep ended.
struct SweepEnd {
    bool interrupted = false;                 ///< what had ended before is in the report
    std::optional<core::BenchmarkRun> fault;  ///< a run that must not be
};

/// Runs these places of the report's plan, each in a process of its own, and adds the runs to those
/// that it has, and to the journal where there is one. The session of the report is then the
/// earlier ones and this one. Precondition: there are places, and no thread has been started.
SweepEnd run_sweep(io::BenchmarkReport& report, std::vector<core::RunPlace> places,
                   std::vector<io::BenchmarkSession> earlier, Journal* journal, bool quiet);

}  // namespace asv::tools
