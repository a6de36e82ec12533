#pragma once

#include <string>
#include <vector>

#include "io/benchmark/report.hpp"
#include "io/benchmark/table/columns.hpp"

/// What the tables of a benchmark say, before it is written in a format: plain words, in which
/// nothing is escaped.

namespace asv::io {

struct TextTable {
    std::string title;
    std::string facts;             ///< below the title; may be empty
    std::size_t word_columns = 1;  ///< the first ones, which hold words; the others hold figures
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> rows;
};

struct ReportText {
    std::vector<std::string> notes;  ///< paragraphs: how it was run, what the columns are
    std::string spoilt;              ///< why times mean nothing; empty where they do
    std::vector<TextTable> tables;
    std::vector<std::string> unsolved;  ///< a line for each reason
};

ReportText report_text(const BenchmarkReport& report, const Columns& columns);

/// A table with these columns behind the first, and no rows.
TextTable empty_table(std::string title, std::string facts, const std::string& first_head,
                      const Columns& columns);

/// What stands first in the row, then its cells. The unit is seconds of 1 u.
std::vector<std::string> summary_row(const std::string& label, const core::Summary& summary,
                                     const Columns& columns, double unit);

/// Each planner on all problems together, a table for each direction, with those of the columns
/// that compare unlike problems; none where there is but one problem.
std::vector<TextTable> overview_tables(const BenchmarkReport& report, const Columns& chosen);

/// Every two planners, in a table without rows where there are no two.
TextTable comparison_table(const BenchmarkReport& report);

/// As Markdown.
std::string markdown(const ReportText& text);

/// As LaTeX with booktabs.
std::string latex(const ReportText& text);

}  // namespace asv::io
