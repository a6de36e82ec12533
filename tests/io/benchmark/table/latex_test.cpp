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
                       "\n\\begin{table}\n\\centering\n\\setlength{\\belowcaptionskip}{6pt}\n"
                       "\\caption{first, forward: 3 ASVs, 1 obstacle; no path costs less than "
                       "2.000.}\n"
                       "\\small\n\\setlength{\\tabcolsep}{4pt}\n"
                       "\\begin{tabular}{lrrr}\n\\toprule\n"
                       "  planner & solved & median ms (95 \\% CI) & cost / bound \\\\\n"
                       "\\midrule\n"
                       "  auto & 2 of 2 & 31.25 (15.62, 46.88) & 1.250 \\\\\n"
                       "  swaps\\textbar{}1 & 2 of 2 & 125.0 (62.50, 187.5) & 1.250 \\\\\n"
                       "\\bottomrule\n\\end{tabular}\n\\end{table}\n"))
        << table;
    EXPECT_TRUE(test::contains(table, " & \\textgreater{}5031 (62.50, \\textgreater{}10000) & "))
        << table;
    EXPECT_TRUE(test::contains(table, "% Not solved: first reversed, swaps|1: timeout")) << table;
}

TEST(LatexTable, NamesAreNoCommands) {
    BenchmarkReport report = test::sample_report();
    report.plan.planners[1].label = "[x]*\\{}$&#_%^~<>\"";
    std::string table = latex_table(report, columns_named("solved"));
    EXPECT_TRUE(test::contains(
        table,
        "\n  "
        "{[}x{]}{*}\\textbackslash{}\\{\\}\\ensuremath{\\mathdollar}\\&\\#\\_\\%\\textasciicircum{}"
        "\\textasciitilde{}\\textless{}\\textgreater{}\\char34{}"
        " & 1 of 2 \\\\\n"))
        << table;
    report.plan.planners[1].label = "''``--\n\\input{x}";
    table = latex_table(report, columns_named("solved"));
    EXPECT_TRUE(test::contains(
        table, "\n  {'}{'}{`}{`}-{}-\\textbackslash{}x0A\\textbackslash{}input\\{x\\} & 1 of 2 "))
        << table;
    EXPECT_FALSE(test::contains(table, "\n\\input")) << "a comment ends with its line";
}

TEST(LatexTable, WhatFindsNoRoomBesideStandsBelow) {
    const std::string table = latex_table(test::sample_report());
    // Four tables of problems, and two of all of them, which have neither checks nor costs.
    for (const char* head : {"\n  planner & solved & ", " & 90 \\% ms ", " & cost / bound "})
        EXPECT_EQ(test::count(table, head), 6U) << head;
    for (const char* head : {" & state checks ", " & first cost "})
        EXPECT_EQ(test::count(table, head), 4U) << head;
    EXPECT_EQ(test::count(table, "\\par\\medskip\n\\begin{tabular}{lll"), 1U) << table;
    EXPECT_EQ(test::count(table, "\\begin{tabular}"), test::count(table, "\\end{tabular}"));
}

TEST(LatexTable, LongNamesAreBroken) {
    BenchmarkReport report = test::sample_report();
    report.plan.planners[0].label = "a_name/without_a_blank";
    const std::string table = latex_table(report, columns_named("solved"));
    EXPECT_TRUE(test::contains(table,
                               "\n  \\parbox[t]{9em}{\\raggedright a\\_\\allowbreak{}name/"
                               "\\allowbreak{}without\\_\\allowbreak{}a\\_\\allowbreak{}blank"
                               "\\allowbreak{}\\strut} & 2 of 2 \\\\\n"))
        << table;
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
