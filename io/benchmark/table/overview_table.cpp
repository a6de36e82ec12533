#include "core/benchmark/summary.hpp"
#include "io/benchmark/report.hpp"
#include "io/benchmark/table/report_text.hpp"

namespace asv::io {

namespace {

constexpr const char* explanation =
    "Shares, medians and means are of all runs of a planner together.";

/// What can be said of runs on unlike problems: no costs, but how far these are above the bounds.
constexpr std::string_view overview_keys = "solved,rate,invalid,median-ms,q90-ms,par2-ms,ratio";

}  // namespace

std::vector<TextTable> overview_tables(const BenchmarkReport& report) {
    const std::size_t problems = report.plan.problems.size();
    std::vector<TextTable> tables;
    if (problems < 2) return tables;
    const Columns columns = columns_named(overview_keys);
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
