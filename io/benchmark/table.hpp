#pragma once

#include <string>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// The benchmark in Markdown: how it was run, one table for each problem and direction with a row
/// for each planner (with a single planner, one table for each direction with a row for each
/// problem), and which runs were not solved and why.
std::string markdown_table(const BenchmarkReport& report);

}  // namespace asv::io
