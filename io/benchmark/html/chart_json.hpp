#pragma once

#include <string>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// What charts.js draws, as JSON: the planners with their colours, and the charts, each with a
/// title and one panel or several to choose from.
std::string chart_json(const BenchmarkReport& report);

}  // namespace asv::io
