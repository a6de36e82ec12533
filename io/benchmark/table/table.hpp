#pragma once

#include <string>

#include "io/benchmark/report.hpp"
#include "io/benchmark/table/columns.hpp"

/// The tables of a benchmark: how it was run, one table for each problem and direction with a row
/// for each planner (with a single planner, one table for each direction with a row for each
/// problem), every two planners compared, and which runs were not solved and why.

namespace asv::io {

/// In Markdown.
std::string markdown_table(const BenchmarkReport& report,
                           const Columns& columns = default_columns());

/// For LaTeX, a file to input where the package booktabs is loaded. What is no table is told in
/// comments, and that times are spoilt in each caption, too.
std::string latex_table(const BenchmarkReport& report, const Columns& columns = default_columns());

}  // namespace asv::io
