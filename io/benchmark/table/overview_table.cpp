#include <algorithm>
#include <array>
#include <string_view>

#include "core/benchmark/summary.hpp"
#include "io/benchmark/report.hpp"
#include "io/benchmark/table/report_text.hpp"

namespace asv::io {

namespace {

constexpr const char* explanation =
    "Shares, medians and means are of all runs of a planner together.";

/// What has no median over unlike problems. How far costs are above the bounds has one.
constexpr std::array<std::string_view, 7> of_one_problem{
    "nodes", "mean-nodes", "checks", "mean-checks", "first-cost", "cost", "cost-ci"};

bool is_among(std::string_view key, const Columns& columns) {
    return std::any_of(columns.begin(), columns.end(),
                       [&](const Column& column) { return column.key == key; });
}

/// Those that compare unlike problems, and how many paths were invalid where any was.
Columns overview_columns(const BenchmarkReport& report, Columns columns) {
    std::erase_if(columns, [](const Column& column) {
        return std::find(of_one_problem.begin(), of_one_problem.end(), column.key) !=
               of_one_problem.end();
    });
    const bool any_invalid = std::any_of(
        report.runs.begin(), report.runs.end(),
        [](const core::BenchmarkRun& run) { return run.status == core::RunStatus::invalid; });
    if (columns.empty()) columns = columns_named("solved");
    if (any_invalid && !is_among("invalid", columns))
        columns.push_back(columns_named("invalid").front());
    return columns;
}

}  // namespace

std::vector<TextTable> overview_tables(const BenchmarkReport& report, const Columns& chosen) {
    const std::size_t problems = report.plan.problems.size();
    std::vector<TextTable> tables;
    if (problems < 2) return tables;
    const Columns columns = overview_columns(report, chosen);
    const core::Summary* last = nullptr;
    const std::vector<core::Summary> summaries =
        core::summarise_over_problems(report.plan, report.runs);
    for (const core::Summary& summary : summaries) {
        if (!last || last->direction != summary.direction)
            tables.push_back(empty_table("All " + std::to_string(problems) + " problems, " +
                                             std::string(core::name(summary.direction)),
                                         explanation, "planner", columns));
        tables.back().rows.push_back(summary_row(report.plan.planners[summary.planner].label,
                                                 summary, columns, report.session.unit()));
        last = &summary;
    }
    return tables;
}

}  // namespace asv::io
