#include <gtest/gtest.h>

#include "io/benchmark/table/table.hpp"
#include "tests/kit/files/benchmark_report_sample.hpp"
#include "tests/kit/files/text.hpp"

namespace asv::io {
namespace {

TEST(LatexTable, IsATableOfBooktabs) {
    const std::string table =
        latex_table(test::sample_report(), columns_named("solved,median-ms,ratio"));
    EXPECT_TRUE(table.starts_with("% Needs \\usepackage{booktabs}.\n% asv-bench 1.2.3, ")) << table;
    EXPECT_TRUE(
        test::contains(table,
                       "\n\\begin{table}\n\\centering\n"
                       "\\caption{first, forward: 3 ASVs, 1 obstacle; no path costs less than "
                       "2.000.}\n"
                       "\\begin{tabular}{lrrr}\n\\toprule\n"
                       "  planner & solved & median ms (95 \\% CI) & cost / bound \\\\\n"
                       "\\midrule\n"
                       "  auto & 2 of 2 & 31.25 (15.62, 46.88) & 1.250 \\\\\n"
                       "  swaps\\textbar{}1 & 2 of 2 & 125.0 (62.50, 187.5) & 1.250 \\\\\n"
                       "\\bottomrule\n\\end{tabular}\n\\end{table}\n"))
        << table;
    EXPECT_TRUE(test::contains(table, " & \\textgreater{}5031 (62.50, \\textgreater{}10000) & "))
        << table;
    EXPECT_TRUE(test::contains(table, "\\begin{tabular}{lllrrrrrr}")) << table;
    EXPECT_TRUE(test::contains(table, "% Not solved: first reversed, swaps|1: timeout")) << table;
}

TEST(LatexTable, NamesAreNoCommands) {
    BenchmarkReport report = test::sample_report();
    report.plan.planners[1].label = "[x]*\\{}$&#_%^~<>\"''``--\n\\input{x}";
    const std::string table = latex_table(report, columns_named("solved"));
    EXPECT_TRUE(
        test::contains(table,
                       "\n  {[}x{]}{*}\\textbackslash{}\\{\\}\\$\\&\\#\\_\\%\\textasciicircum{}"
                       "\\textasciitilde{}\\textless{}\\textgreater{}\\char34{}{'}{'}{`}{`}-{}-"
                       "\\textbackslash{}x0A\\textbackslash{}input\\{x\\} & 1 of 2 \\\\\n"))
        << table;
    EXPECT_FALSE(test::contains(table, "\n\\input")) << "a comment ends with its line";
}

TEST(LatexTable, EveryCaptionSaysThatTimesAreSpoilt) {
    BenchmarkReport report = test::sample_report();
    report.plan.jobs = 3;
    const std::string table = latex_table(report);
    EXPECT_EQ(test::count(table, "\\caption{"), 7U);
    EXPECT_EQ(test::count(table, "3 runs side by side: their times are spoilt.}"), 7U);
}

}  // namespace
}  // namespace asv::io
