#pragma once

#include <string>

#include "io/benchmark/report.hpp"
#include "io/benchmark/table/columns.hpp"

namespace asv::io {

/// Was Chart.js there when this was built? html_page() needs it.
bool has_charts();

/// A page of the benchmark that needs no other file and no network: its tables, which planner
/// solves which problem, and charts that can be pointed at: shares solved over time, cost over
/// time, performance profiles, and curves over the report's parameter where it has one. Throws
/// std::logic_error without charts.
std::string html_page(const BenchmarkReport& report, const Columns& columns = default_columns());

}  // namespace asv::io
