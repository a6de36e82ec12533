#include "io/benchmark/table/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "io/benchmark/report.hpp"

namespace asv::io {

namespace {

using core::Summary;
using core::statistics::CensoredValue;
using core::statistics::Spread;

constexpr double milliseconds = 1000;  // of a second

CensoredValue scaled(const CensoredValue& value, double factor) {
    return {value.value * factor, value.censored};
}

std::string time_quantile(const Summary& summary, double share, double factor) {
    return figure(scaled(quantile(summary.time_to_solution, share), factor));
}

std::string median_time(const Summary& summary, double factor) {
    return with_interval(time_quantile(summary, 0.5, factor),
                         figure(scaled(summary.median_time.low, factor)),
                         figure(scaled(summary.median_time.high, factor)));
}

std::string penalised_time(const Summary& summary, double factor) {
    return short_number(factor * penalised_mean(summary.time_to_solution));
}

std::string rate(const Summary& summary) {
    const double share = static_cast<double>(summary.solved) / static_cast<double>(summary.runs);
    return with_interval(short_number(100 * share), short_number(100 * summary.success.low),
                         short_number(100 * summary.success.high));
}

/// A figure of solved runs.
std::string if_any(const Spread& spread, double value) {
    return spread.count > 0 ? short_number(value) : "-";
}

std::string whole_median(const Spread& count) {
    return count.count > 0 ? std::to_string(static_cast<long long>(count.median)) : "-";
}

std::string whole_mean(const Spread& count) {
    return count.count > 0 ? std::to_string(std::llround(count.mean)) : "-";
}

std::string median_cost(const Summary& summary) {
    if (summary.cost.count == 0) return "-";
    return with_interval(short_number(summary.cost.median), short_number(summary.median_cost.low),
                         short_number(summary.median_cost.high));
}

constexpr std::array<Column, 27> catalogue{{
    {"solved", "solved",
     [](const Summary& row, double) {
         return std::to_string(row.solved) + " of " + std::to_string(row.runs);
     }},
    {"rate", "rate % (95 % CI)", [](const Summary& row, double) { return rate(row); }},
    {"invalid", "invalid, of paths found",
     [](const Summary& row, double) {
         return std::to_string(row.invalid) + " of " + std::to_string(row.solved + row.invalid);
     }},
    {"median-ms", "median ms (95 % CI)",
     [](const Summary& row, double) { return median_time(row, milliseconds); }},
    {"q25-ms", "25 % ms",
     [](const Summary& row, double) { return time_quantile(row, 0.25, milliseconds); }},
    {"q75-ms", "75 % ms",
     [](const Summary& row, double) { return time_quantile(row, 0.75, milliseconds); }},
    {"q90-ms", "90 % ms",
     [](const Summary& row, double) { return time_quantile(row, 0.9, milliseconds); }},
    {"worst-ms", "worst ms",
     [](const Summary& row, double) { return time_quantile(row, 1, milliseconds); }},
    {"par2-ms", "PAR-2 ms",
     [](const Summary& row, double) { return penalised_time(row, milliseconds); }},
    {"median-u", "median u",
     [](const Summary& row, double unit) { return time_quantile(row, 0.5, 1 / unit); }},
    {"median-u-ci", "median u (95 % CI)",
     [](const Summary& row, double unit) { return median_time(row, 1 / unit); }},
    {"q90-u", "90 % u",
     [](const Summary& row, double unit) { return time_quantile(row, 0.9, 1 / unit); }},
    {"worst-u", "worst u",
     [](const Summary& row, double unit) { return time_quantile(row, 1, 1 / unit); }},
    {"par2-u", "PAR-2 u",
     [](const Summary& row, double unit) { return penalised_time(row, 1 / unit); }},
    {"solved-median-ms", "median ms, solved only",
     [](const Summary& row, double) {
         return if_any(row.time_to_first, milliseconds * row.time_to_first.median);
     }},
    {"solved-worst-ms", "worst ms, solved only",
     [](const Summary& row, double) {
         return if_any(row.time_to_first, milliseconds * row.time_to_first.greatest);
     }},
    {"solved-mean-ms", "mean ms, solved only",
     [](const Summary& row, double) {
         return if_any(row.time_to_first, milliseconds * row.time_to_first.mean);
     }},
    {"solved-std-ms", "std ms, solved only",
     [](const Summary& row, double) {
         return if_any(row.time_to_first, milliseconds * row.time_to_first.deviation);
     }},
    {"solved-mean-u", "mean u, solved only",
     [](const Summary& row, double unit) {
         return if_any(row.time_to_first, row.time_to_first.mean / unit);
     }},
    {"nodes", "nodes", [](const Summary& row, double) { return whole_median(row.nodes); }},
    {"checks", "state checks",
     [](const Summary& row, double) { return whole_median(row.state_checks); }},
    {"mean-nodes", "mean nodes", [](const Summary& row, double) { return whole_mean(row.nodes); }},
    {"mean-checks", "mean state checks",
     [](const Summary& row, double) { return whole_mean(row.state_checks); }},
    {"first-cost", "first cost",
     [](const Summary& row, double) { return if_any(row.cost_first, row.cost_first.median); }},
    {"cost", "cost", [](const Summary& row, double) { return if_any(row.cost, row.cost.median); }},
    {"cost-ci", "cost (95 % CI)", [](const Summary& row, double) { return median_cost(row); }},
    {"ratio", "cost / bound",
     [](const Summary& row, double) { return if_any(row.ratio, row.ratio.median); }},
}};

/// How sure, how fast, how much work, how good: what a reader asks first.
constexpr std::string_view usual_keys =
    "solved,rate,median-ms,q90-ms,par2-ms,median-u,checks,first-cost,cost-ci,ratio";

const Column& column_named(std::string_view key) {
    const auto found = std::find_if(catalogue.begin(), catalogue.end(),
                                    [&](const Column& column) { return column.key == key; });
    if (found != catalogue.end()) return *found;
    std::string all;
    for (const Column& column : catalogue) {
        if (!all.empty()) all += ", ";
        all += column.key;
    }
    throw std::invalid_argument("there is no column '" + std::string(key) + "'; there are " + all);
}

}  // namespace

std::span<const Column> all_columns() {
    return catalogue;
}

Columns default_columns() {
    return columns_named(usual_keys);
}

Columns columns_named(std::string_view keys) {
    Columns chosen;
    for (std::size_t begin = 0; begin <= keys.size();) {
        const std::size_t end = std::min(keys.find(',', begin), keys.size());
        chosen.push_back(column_named(keys.substr(begin, end - begin)));
        begin = end + 1;
    }
    return chosen;
}

std::string figure(const CensoredValue& value) {
    std::string text = value.censored ? ">" : "";
    return text += short_number(value.value);
}

std::string with_interval(const std::string& figure, const std::string& low,
                          const std::string& high) {
    return figure + " (" + low + ", " + high + ")";
}

}  // namespace asv::io
