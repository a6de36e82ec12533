#include "core/benchmark/comparison.hpp"
#include "io/benchmark/report.hpp"
#include "io/benchmark/table/report_text.hpp"

namespace asv::io {

namespace {

constexpr const char* explanation =
    "A pair is a run of each planner on the same problem in the same direction with the same "
    "seed. Times are to the first path, a run that is not solved counting with the time limit; "
    "costs are of the pairs that both solved. Ratio: the median of first / second. A12: the "
    "chance that a run of the first takes or costs less than one of the second (0.5: neither is "
    "better). Better on: problems and directions where the first has the lesser median, and the "
    "second. p: Wilcoxon's signed rank test of the logarithms of the ratios, two-sided; p "
    "(Holm): corrected for the number of rows. They speak of these problems, not of others.";

std::string p_text(double p) {
    constexpr double least_told = 1e-4;
    return p < least_told ? "<0.0001" : short_number(p);
}

std::vector<std::string> row(const BenchmarkReport& report, const core::Comparison& comparison) {
    const auto label = [&](std::size_t planner) { return report.plan.planners[planner].label; };
    return {
        comparison.measure == core::Measure::time ? "time" : "cost",
        label(comparison.first),
        label(comparison.second),
        std::to_string(comparison.test.pairs),
        with_interval(short_number(comparison.ratio), short_number(comparison.ratio_interval.low),
                      short_number(comparison.ratio_interval.high)),
        short_number(comparison.chance_of_less),
        std::to_string(comparison.first_better) + " : " + std::to_string(comparison.second_better),
        p_text(comparison.test.p),
        p_text(comparison.corrected_p)};
}

}  // namespace

TextTable comparison_table(const BenchmarkReport& report) {
    TextTable table{
        "Planners compared",
        explanation,
        3,
        {"of", "first", "second", "pairs", "ratio (95 % CI)", "A12", "better on", "p", "p (Holm)"},
        {}};
    for (const core::Comparison& comparison : core::compare_planners(report.plan, report.runs))
        table.rows.push_back(row(report, comparison));
    return table;
}

}  // namespace asv::io
