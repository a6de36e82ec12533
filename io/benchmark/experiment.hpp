#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/benchmark/report.hpp"

/// A benchmark as OMPL's tools see it: experiments, which have planners, which have runs with
/// attributes. What the text log and the database of Planner Arena have in common.

namespace asv::io {

/// The text with _ for each blank and each control character, since names of OMPL end with a blank.
std::string without_blanks(std::string text);

/// One problem in one direction: an experiment of Planner Arena.
struct Experiment {
    std::string name;  ///< without blanks: "7ASV", "7ASV-reversed"
    std::size_t problem = 0;
    core::Direction direction = core::Direction::forward;
};

/// Those of the plan that have runs, in its order.
std::vector<Experiment> experiments(const BenchmarkReport& report);

/// The runs of the experiment with this planner.
std::vector<const core::BenchmarkRun*> runs_of(const BenchmarkReport& report,
                                               const Experiment& experiment, std::size_t planner);

/// What an attribute of a run may be; nothing where it is not known.
using AttributeValue = std::variant<std::monostate, std::int64_t, double>;

/// One property of a run, as OMPL names and types it: "solution length", "REAL".
struct Attribute {
    std::string_view name, type;
    AttributeValue (*value)(const BenchmarkReport&, const core::BenchmarkRun&);
};

std::span<const Attribute> run_attributes();

/// Name of the column in the database: "solution_length".
std::string column_name(std::string_view attribute);

/// The words for the values of the attribute `status`, from 0 on: those of OMPL.
std::span<const std::string_view> status_words();

/// What the experiment was, in some lines: problem, options, the unit of time.
std::string setup_text(const BenchmarkReport& report, const Experiment& experiment);

/// All settings of the planner with their values: "name = value", the name of the planner first.
std::vector<std::string> setting_lines(const core::BenchmarkPlanner& planner);

}  // namespace asv::io
