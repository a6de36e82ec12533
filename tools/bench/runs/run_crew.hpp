#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "core/benchmark/run.hpp"

namespace asv::tools {

/// Who does the runs of a plan: processes here, or on other machines too.
class RunCrew {
  public:
    RunCrew() = default;
    virtual ~RunCrew() = default;
    RunCrew(const RunCrew&) = delete;
    RunCrew& operator=(const RunCrew&) = delete;

    /// Runs at once.
    virtual std::size_t size() const = 0;

    /// Does a run of the plan, from as many threads at once as the crew has members. Once a stop is
    /// requested it is cut off, and says nothing.
    virtual core::BenchmarkRun run(const core::RunPlace& place, const std::stop_token& abort) = 0;

    /// What users are told of it once the runs have ended, a line; empty for nothing.
    virtual std::string summary() const { return {}; }
};

/// Finds the crew for a plan, which outlives it. The caller has started no thread; it watches for
/// signals that interrupt from then on, which may be blocked meanwhile.
using HireCrew = std::function<std::unique_ptr<RunCrew>(const core::BenchmarkPlan&)>;

}  // namespace asv::tools
