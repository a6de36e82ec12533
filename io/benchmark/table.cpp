#include "io/benchmark/table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "core/benchmark/summary.hpp"
#include "io/benchmark/wording.hpp"
#include "io/text/escape.hpp"

namespace asv::io {

namespace {

using core::BenchmarkRun;
using core::Spread;
using core::Summary;

/// What would end a cell, or begin a tag, a link, a picture or code, is written in another way.
std::string cell(std::string_view text) {
    constexpr std::string_view with_meaning = "|\\[]`";
    std::string result;
    for (const char letter : escaped(text)) {
        // A bar is escaped by a backslash, which therefore must not stand alone.
        if (with_meaning.find(letter) != std::string_view::npos) result += '\\';
        if (letter == '<')
            result += "&lt;";
        else
            result += letter;
    }
    return result;
}

std::string heading(const BenchmarkReport& report) {
    const core::BenchmarkPlan& plan = report.plan;
    const BenchmarkSession& session = report.session;
    std::string text = "asv-bench " + session.version + ", " + utc_text(session.started) +
                       " UTC, " + cell(session.host) + " (" + cell(session.cpu) + ", " +
                       plural(session.processors, "processor") + "). " + plan_facts(plan) + ".";
    if (plan.jobs > 1)
        text.append(" ")
            .append(plural(plan.jobs, "run"))
            .append(" side by side: their times are spoilt.");
    text += sessions_note(session);
    if (!report.complete())
        text += " Interrupted: " + std::to_string(report.runs.size()) + " of " +
                std::to_string(core::run_count(plan)) + " runs.";
    text +=
        "\n\nTimes are to the first path, of the solved runs: a run that is not solved counts in "
        "no column but the second, so compare that one first. 1 u is the time of 10^6 scalar "
        "state checks of 7 ASVs in this session: " +
        short_number(1000 * session.unit()) + " ms (" + short_number(1000 * session.unit_before) +
        " before the runs, " + short_number(1000 * session.unit_after) +
        " after them). Nodes, state checks and costs are medians.\n";
    return text;
}

/// The greatest that any planner's runs know: those that are not solved have none.
double bound_of(std::span<const Summary> summaries, std::size_t problem) {
    double bound = 0;
    for (const Summary& summary : summaries)
        if (summary.problem == problem) bound = std::max(bound, summary.lower_bound);
    return bound;
}

std::string row(const std::string& label, const Summary& summary, double unit) {
    const bool any = summary.solved > 0;
    const auto figure = [](bool known, double value) {
        return known ? short_number(value) : std::string("-");
    };
    const Spread& time = summary.time_to_first;
    const std::array<double, 7> times{
        1000 * time.median, 1000 * time.greatest, 1000 * time.mean, 1000 * time.deviation,
        time.median / unit, time.greatest / unit, time.mean / unit};
    std::string text = "| " + cell(label) + " | " + std::to_string(summary.solved) + " of " +
                       std::to_string(summary.runs);
    for (const double value : times) text += " | " + figure(any, value);
    for (const Spread* count : {&summary.nodes, &summary.state_checks})
        text += " | " + (any ? std::to_string(static_cast<long long>(count->median)) : "-");
    for (const Spread* cost : {&summary.cost_first, &summary.cost, &summary.ratio})
        text += " | " + figure(cost->count > 0, cost->median);
    return text + " |\n";
}

std::string column_heads(const std::string& first) {
    return "| " + first +
           " | solved | median ms | worst ms | mean ms | std ms | median u | worst u | mean u "
           "| nodes | state checks | first cost | cost | cost / bound |\n"
           "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
}

/// The runs without a solution, those with one status and reason together.
std::string unsolved(const BenchmarkReport& report) {
    using Group = std::tuple<std::size_t, core::Direction, std::size_t, std::string, std::string>;
    std::map<Group, std::string> seeds;
    for (const BenchmarkRun& run : report.runs) {
        if (run.solved()) continue;
        std::string& list = seeds[{run.place.problem, run.place.direction, run.place.planner,
                                   std::string(core::name(run.status)), run.reason}];
        list += (list.empty() ? "" : ", ") + std::to_string(run.place.seed);
    }
    if (seeds.empty()) return {};
    std::string text = "\nNot solved:\n\n";
    for (const auto& [group, list] : seeds) {
        const auto& [problem, direction, planner, status, reason] = group;
        text += "- " + cell(report.plan.problems[problem].name) + " " +
                std::string(core::name(direction)) + ", " +
                cell(report.plan.planners[planner].label) + ": " + status + " (" + cell(reason) +
                "), " + (list.find(',') == std::string::npos ? "seed " : "seeds ") + list + "\n";
    }
    return text;
}

/// A table for each problem and direction, a row for each planner.
std::string tables_of_problems(const BenchmarkReport& report, std::span<const Summary> summaries) {
    std::string text;
    const Summary* last = nullptr;
    for (const Summary& summary : summaries) {
        const core::BenchmarkProblem& problem = report.plan.problems[summary.problem];
        if (!last || last->problem != summary.problem || last->direction != summary.direction)
            text += "\n### " + cell(problem.name) + ", " +
                    std::string(core::name(summary.direction)) + "\n\n" +
                    problem_facts(problem.problem, bound_of(summaries, summary.problem)) + ".\n\n" +
                    column_heads("planner");
        text += row(report.plan.planners[summary.planner].label, summary, report.session.unit());
        last = &summary;
    }
    return text;
}

/// A table for each direction, a row for each problem.
std::string tables_of_planner(const BenchmarkReport& report, std::span<const Summary> summaries) {
    std::string text;
    for (const core::Direction direction : report.plan.directions) {
        std::string rows;
        for (const Summary& summary : summaries)
            if (summary.direction == direction)
                rows +=
                    row(report.plan.problems[summary.problem].name, summary, report.session.unit());
        if (rows.empty()) continue;
        text += "\n### " + cell(report.plan.planners[0].label) + ", " +
                std::string(core::name(direction)) + "\n\n" + column_heads("problem") + rows;
    }
    return text;
}

}  // namespace

std::string markdown_table(const BenchmarkReport& report) {
    const std::vector<Summary> summaries = core::summarise(report.plan, report.runs);
    const bool one_planner = report.plan.planners.size() == 1;
    return heading(report) +
           (one_planner ? tables_of_planner(report, summaries)
                        : tables_of_problems(report, summaries)) +
           unsolved(report);
}

}  // namespace asv::io
