#include "io/benchmark/html/table_markup.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include "core/benchmark/summary.hpp"
#include "io/text/escape.hpp"
#include "io/text/markup.hpp"

namespace asv::io {

namespace {

using core::Summary;

/// A table that can be scrolled sideways, by the keyboard too.
std::string scrolled(const std::string& label, const std::string& head, const std::string& rows) {
    return "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + label +
           "\"><table>\n<thead><tr>" + head + "</tr></thead>\n<tbody>\n" + rows +
           "</tbody></table></div>\n";
}

std::string head_cell(std::string_view words, const char* scope, bool figures) {
    return std::string("<th scope=\"") + scope + "\"" + (figures ? " class=\"figure\"" : "") + ">" +
           words_markup(words) + "</th>";
}

std::string row_markup(const std::vector<std::string>& cells, std::size_t word_columns) {
    std::string row = "<tr>" + head_cell(cells[0], "row", false);
    for (std::size_t i = 1; i < cells.size(); ++i)
        row += (i < word_columns ? "<td>" : "<td class=\"figure\">") + words_markup(cells[i]) +
               "</td>";
    return row + "</tr>\n";
}

std::string success_cell(const Summary& summary) {
    const auto percent = 100 * summary.solved / summary.runs;
    return "<td class=\"figure share\" style=\"--share: " + std::to_string(percent) + "%\">" +
           std::to_string(summary.solved) + " of " + std::to_string(summary.runs) + "</td>";
}

/// Of summaries of one task; a planner that did not run there has an empty cell.
std::string success_row(const core::BenchmarkPlan& plan, std::span<const Summary> task) {
    std::string row = "<tr>" + head_cell(plan.problems[task[0].problem].name + ", " +
                                             std::string(core::name(task[0].direction)),
                                         "row", false);
    std::size_t next = 0;
    for (std::size_t planner = 0; planner < plan.planners.size(); ++planner) {
        const bool has_run = next < task.size() && task[next].planner == planner;
        row += has_run ? success_cell(task[next++]) : "<td></td>";
    }
    return row + "</tr>\n";
}

}  // namespace

std::string words_markup(std::string_view words) {
    return escape_markup(escaped(words));
}

std::string table_markup(const TextTable& table) {
    const std::string title = words_markup(table.title);
    std::string text = "<section>\n<h3>" + title + "</h3>\n";
    if (!table.facts.empty()) text += "<p>" + words_markup(table.facts) + "</p>\n";
    std::string head, rows;
    for (std::size_t i = 0; i < table.heads.size(); ++i)
        head += head_cell(table.heads[i], "col", i >= table.word_columns);
    for (const std::vector<std::string>& row : table.rows)
        rows += row_markup(row, table.word_columns);
    return text + scrolled(title, head, rows) + "</section>\n";
}

std::string success_markup(const BenchmarkReport& report) {
    const std::vector<Summary> summaries = core::summarise(report.plan, report.runs);
    std::string head = head_cell("problem", "col", false), rows;
    for (const core::BenchmarkPlanner& planner : report.plan.planners)
        head += head_cell(planner.label, "col", true);
    for (std::size_t begin = 0, end = 0; begin < summaries.size(); begin = end) {
        while (end < summaries.size() && summaries[end].problem == summaries[begin].problem &&
               summaries[end].direction == summaries[begin].direction)
            ++end;
        rows += success_row(report.plan, std::span(summaries).subspan(begin, end - begin));
    }
    return scrolled("Success by problem", head, rows);
}

}  // namespace asv::io
