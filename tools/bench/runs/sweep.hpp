#pragma once

#include <optional>
#include <vector>

#include "io/benchmark/report.hpp"
#include "tools/bench/records/journal.hpp"
#include "tools/bench/runs/run_crew.hpp"

namespace asv::tools {

/// How a sweep ended.
struct SweepEnd {
    bool interrupted = false;                 ///< what had ended before is in the report
    std::optional<core::BenchmarkRun> fault;  ///< a run that must not be
};

/// Has a crew run these places of the report's plan, and adds the runs to those
/// that it has, and to the journal where there is one. The session of the report is then the
/// earlier ones and this one. Precondition: there are places, and no thread has been started.
SweepEnd run_sweep(io::BenchmarkReport& report, std::vector<core::RunPlace> places,
                   std::vector<io::BenchmarkSession> earlier, Journal* journal,
                   const HireCrew& hire, bool quiet);

}  // namespace asv::tools
