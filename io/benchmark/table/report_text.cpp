#include "io/benchmark/table/report_text.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>

#include "core/benchmark/summary.hpp"
#include "io/benchmark/wording.hpp"

namespace asv::io {

namespace {

using core::BenchmarkRun;
using core::Summary;

std::string session_note(const BenchmarkReport& report) {
    const core::BenchmarkPlan& plan = report.plan;
    const BenchmarkSession& session = report.session;
    std::string text = "asv-bench " + session.version + ", " + utc_text(session.started) +
                       " UTC, " + session.host + " (" + session.cpu + ", " +
                       plural(session.processors, "processor") + "). " + plan_facts(plan) + ".";
    if (const std::string spoilt = spoilt_note(plan); !spoilt.empty()) text += " " + spoilt;
    text += sessions_note(session);
    if (!report.complete())
        text += " Interrupted: " + std::to_string(report.runs.size()) + " of " +
                std::to_string(core::run_count(plan)) + " runs.";
    return text;
}

std::string unit_note(const BenchmarkSession& session) {
    return "1 u is the time of 10^6 scalar state checks of 7 ASVs in this session: " +
           short_number(1000 * session.unit()) + " ms (" +
           short_number(1000 * session.unit_before) + " before the runs, " +
           short_number(1000 * session.unit_after) + " after them).";
}

std::vector<std::string> notes_of(const BenchmarkReport& report) {
    return {
        session_note(report),
        "Times are to the first path. A run that is not solved takes longer than the time "
        "limit: it counts in medians and quantiles, and a figure that is known to be greater "
        "only has a > before it. In PAR-2, the mean, it counts with twice the limit. Nodes, "
        "checks and costs are medians of the solved runs, and so is what is said to be of "
        "them only.",
        "In parentheses are confidence intervals: of rates by Clopper and Pearson, of medians by "
        "the percentile bootstrap. " +
            unit_note(report.session)};
}

/// The greatest that any planner's runs know: those that are not solved have none.
double bound_of(std::span<const Summary> summaries, std::size_t problem) {
    double bound = 0;
    for (const Summary& summary : summaries)
        if (summary.problem == problem) bound = std::max(bound, summary.lower_bound);
    return bound;
}

/// A table for each problem and direction, a row for each planner.
std::vector<TextTable> tables_of_problems(const BenchmarkReport& report, const Columns& columns) {
    const std::vector<Summary> summaries = core::summarise(report.plan, report.runs);
    std::vector<TextTable> tables;
    const Summary* last = nullptr;
    for (const Summary& summary : summaries) {
        const core::BenchmarkProblem& problem = report.plan.problems[summary.problem];
        if (!last || last->problem != summary.problem || last->direction != summary.direction)
            tables.push_back(empty_table(
                problem.name + ", " + std::string(core::name(summary.direction)),
                problem_facts(problem.problem, bound_of(summaries, summary.problem)) + ".",
                "planner", columns));
        tables.back().rows.push_back(summary_row(report.plan.planners[summary.planner].label,
                                                 summary, columns, report.session.unit()));
        last = &summary;
    }
    return tables;
}

/// A table for each direction, a row for each problem.
std::vector<TextTable> tables_of_planner(const BenchmarkReport& report, const Columns& columns) {
    const std::vector<Summary> summaries = core::summarise(report.plan, report.runs);
    std::vector<TextTable> tables;
    for (const core::Direction direction : report.plan.directions) {
        TextTable table =
            empty_table(report.plan.planners[0].label + ", " + std::string(core::name(direction)),
                        "", "problem", columns);
        for (const Summary& summary : summaries)
            if (summary.direction == direction)
                table.rows.push_back(summary_row(report.plan.problems[summary.problem].name,
                                                 summary, columns, report.session.unit()));
        if (!table.rows.empty()) tables.push_back(std::move(table));
    }
    return tables;
}

/// The runs without a solution, those with one status and reason together.
std::vector<std::string> unsolved_lines(const BenchmarkReport& report) {
    using Group = std::tuple<std::size_t, core::Direction, std::size_t, std::string, std::string>;
    std::map<Group, std::string> seeds;
    for (const BenchmarkRun& run : report.runs) {
        if (run.solved()) continue;
        std::string& list = seeds[{run.place.problem, run.place.direction, run.place.planner,
                                   std::string(core::name(run.status)), run.reason}];
        list += (list.empty() ? "" : ", ") + std::to_string(run.place.seed);
    }
    std::vector<std::string> lines;
    for (const auto& [group, list] : seeds) {
        const auto& [problem, direction, planner, status, reason] = group;
        lines.push_back(report.plan.problems[problem].name + " " +
                        std::string(core::name(direction)) + ", " +
                        report.plan.planners[planner].label + ": " + status + " (" + reason +
                        "), " + (list.find(',') == std::string::npos ? "seed " : "seeds ") + list);
    }
    return lines;
}

}  // namespace

TextTable empty_table(std::string title, std::string facts, const std::string& first_head,
                      const Columns& columns) {
    TextTable table{std::move(title), std::move(facts), 1, {first_head}, {}};
    for (const Column& column : columns) table.heads.emplace_back(column.head);
    return table;
}

std::vector<std::string> summary_row(const std::string& label, const Summary& summary,
                                     const Columns& columns, double unit) {
    std::vector<std::string> cells{label};
    for (const Column& column : columns) cells.push_back(column.cell(summary, unit));
    return cells;
}

ReportText report_text(const BenchmarkReport& report, const Columns& columns) {
    const bool one_planner = report.plan.planners.size() == 1;
    ReportText text{
        notes_of(report), spoilt_note(report.plan),
        one_planner ? tables_of_planner(report, columns) : tables_of_problems(report, columns),
        unsolved_lines(report)};
    for (TextTable& overview : overview_tables(report, columns))
        text.tables.push_back(std::move(overview));
    if (TextTable comparisons = comparison_table(report); !comparisons.rows.empty())
        text.tables.push_back(std::move(comparisons));
    return text;
}

}  // namespace asv::io
