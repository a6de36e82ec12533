#pragma once

#include <string>
#include <string_view>

#include "io/benchmark/report.hpp"
#include "io/benchmark/table/report_text.hpp"

namespace asv::io {

/// Words of a report as they may stand in a page: control characters and the like as escaped() has
/// them, what HTML reserves as entities.
std::string words_markup(std::string_view words);

/// The table with its title and facts as a section.
std::string table_markup(const TextTable& table);

/// How many runs each planner has solved of each problem in each direction, fuller cells for more.
std::string success_markup(const BenchmarkReport& report);

}  // namespace asv::io
