#pragma once

#include <string>
#include <vector>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// In what the limits of two benchmarks differ, without which their runs do not compare: version,
/// time limit, improvement, threads, memory limit. "time limit: 10 s here, 5 s there"; empty when
/// they agree.
std::vector<std::string> differing_limits(const BenchmarkReport& here,
                                          const BenchmarkReport& there);

/// The same for all that is run: limits, jobs, seeds, directions, problems and their contents,
/// planners and their settings.
std::vector<std::string> differing_plans(const BenchmarkReport& here, const BenchmarkReport& there);

/// "Seeds 1 to 10" as "1 to 10".
std::string seed_range(const core::BenchmarkPlan& plan);

}  // namespace asv::io
