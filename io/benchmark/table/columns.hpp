#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/benchmark/statistics/statistics.hpp"
#include "core/benchmark/summary.hpp"

namespace asv::io {

/// A column of the tables of a benchmark.
struct Column {
    std::string_view key;   ///< what --columns of asv-bench calls it
    std::string_view head;  ///< what stands above it
    /// The cell of a planner's row; "-" where nothing is known. The unit is seconds of 1 u.
    std::string (*cell)(const core::Summary& summary, double unit);
};

using Columns = std::vector<Column>;

/// All there are.
std::span<const Column> all_columns();

/// Those that a table has unless told otherwise.
Columns default_columns();

/// "solved,median-ms" and the like, in that order. Throws std::invalid_argument, which lists all
/// keys, for one that there is not, and for an empty list.
Columns columns_named(std::string_view keys);

/// "12.35", or ">12.35" where the value is known to be greater only.
std::string figure(const core::statistics::CensoredValue& value);

/// "12.35 (10.12, 15.68)".
std::string with_interval(const std::string& figure, const std::string& low,
                          const std::string& high);

}  // namespace asv::io
