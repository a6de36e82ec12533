#pragma once

#include <string>
#include <vector>

#include "io/benchmark/report.hpp"

namespace asv::tools {

/// The runs of all these files (--json, --resume) together. Throws UsageError where they do not
/// belong together, ParseError, ReadError.
io::BenchmarkReport earlier_runs(const std::vector<std::string>& files);

/// Adds planners that the report does not have; one that it has must be the same. Returns the
/// indices of all of them. Throws UsageError.
std::vector<std::size_t> add_planners(io::BenchmarkReport& report,
                                      const std::vector<core::BenchmarkPlanner>& planners);

/// The files of the problems, as they were given when they were run.
std::vector<std::string> problem_files(const core::BenchmarkPlan& plan);

/// Puts the problems as they have been read in the place of those of which only a record was there.
/// Throws UsageError where one is not what it was.
void put_in_place(std::vector<core::BenchmarkProblem> read, core::BenchmarkPlan& plan);

/// The places of the plan that have no run, of these planners alone.
std::vector<core::RunPlace> missing_runs(const io::BenchmarkReport& report,
                                         const std::vector<std::size_t>& planners);

/// The same for all planners.
std::vector<core::RunPlace> missing_runs(const io::BenchmarkReport& report);

}  // namespace asv::tools
