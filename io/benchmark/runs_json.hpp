#pragma once

#include <string>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// The whole benchmark as one JSON object: the session, problems, planners with all their settings,
/// a summary for each row of the tables, and every run with its cost history and the command that
/// repeats it. Times in seconds, costs in workspace units; what is not known is null.
std::string runs_json(const BenchmarkReport& report);

}  // namespace asv::io
