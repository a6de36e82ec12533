#pragma once

#include <string>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// One line for each run below a line of column names, as RFC 4180 has it (but with plain line
/// ends): times in seconds, costs in workspace units; what is not known is empty.
/// With more than one job, runs side by side, the times are spoilt.
std::string runs_csv(const BenchmarkReport& report);

}  // namespace asv::io
