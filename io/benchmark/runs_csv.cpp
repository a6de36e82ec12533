#include "io/benchmark/runs_csv.hpp"

#include <cmath>
#include <optional>
#include <string_view>

#include "core/benchmark/summary.hpp"
#include "io/text/escape.hpp"
#include "io/text/number_text.hpp"

namespace asv::io {

namespace {

constexpr std::string_view head_line =
    "problem,planner,settings,direction,seed,threads,status,reason,time_to_first_s,"
    "time_to_first_u,time_total_s,cost_first,cost_of_search,cost,cost_lower_bound,cost_ratio,"
    "primitive_steps,primitive_steps_lower_bound,tree_nodes,iterations,state_checks,edge_checks,"
    "peak_memory_bytes,jobs\n";

/// A text that a spreadsheet would take for a formula gets an apostrophe in front; bytes that are
/// no text are escaped.
std::string csv_words(std::string_view text) {
    constexpr std::string_view begins_formula = "=+-@\t\r";
    const bool formula = !text.empty() && begins_formula.find(text[0]) != std::string_view::npos;
    std::string cell(formula ? "'" : "");
    return cell += escaped(text);
}

/// The fields of one line.
class Line {
  public:
    void add(std::string_view words) {
        separate();
        const std::string text = csv_words(words);
        if (text.find_first_of(",\"\r\n") == std::string::npos) {
            text_ += text;
            return;
        }
        text_ += '"';
        for (const char letter : text) {
            if (letter == '"') text_ += '"';
            text_ += letter;
        }
        text_ += '"';
    }
    void add(std::size_t count) { add(std::to_string(count)); }
    void add(std::optional<double> value) {
        separate();
        if (value && std::isfinite(*value)) append_number(text_, *value);
    }

    std::string end() { return std::move(text_) + "\n"; }

  private:
    void separate() {
        if (!first_) text_ += ',';
        first_ = false;
    }

    std::string text_;
    bool first_ = true;
};

std::string line_of(const BenchmarkReport& report, const core::BenchmarkRun& run) {
    const core::BenchmarkPlan& plan = report.plan;
    const core::BenchmarkPlanner& planner = plan.planners[run.place.planner];
    const core::SolveStatistics& spent = run.spent;
    const auto if_solved = [&](double value) {
        return run.solved() ? std::optional(value) : std::nullopt;
    };
    const auto if_known = [](double bound) {
        return bound > 0 ? std::optional(bound) : std::nullopt;
    };
    Line line;
    line.add(std::string_view(plan.problems[run.place.problem].name));
    line.add(std::string_view(planner.label));
    line.add(std::string_view(planner_text(planner)));
    line.add(core::name(run.place.direction));
    line.add(static_cast<std::size_t>(run.place.seed));
    line.add(plan.threads);
    line.add(core::name(run.status));
    line.add(std::string_view(run.reason));
    line.add(if_solved(spent.time_to_first));
    line.add(if_solved(spent.time_to_first / report.session.unit()));
    line.add(std::optional(spent.time_total));
    for (const double cost : {spent.cost_first, spent.cost_of_search, spent.cost})
        line.add(if_solved(cost));
    line.add(if_known(spent.cost_lower_bound));
    line.add(core::cost_ratio(run));
    line.add(run.primitive_steps);
    line.add(if_known(static_cast<double>(spent.steps_lower_bound)));
    for (const std::size_t count :
         {core::node_count(run), spent.iterations, static_cast<std::size_t>(spent.state_checks),
          static_cast<std::size_t>(spent.edge_checks)})
        line.add(count);
    line.add(run.peak_memory_bytes ? std::to_string(*run.peak_memory_bytes) : std::string());
    line.add(plan.jobs);
    return line.end();
}

}  // namespace

std::string runs_csv(const BenchmarkReport& report) {
    std::string text{head_line};
    for (const core::BenchmarkRun& run : report.runs) text += line_of(report, run);
    return text;
}

}  // namespace asv::io
