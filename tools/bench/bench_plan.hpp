#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/benchmark/plan.hpp"
#include "tools/common/command_line.hpp"

namespace asv::tools {

/// A planner from "[LABEL:] NAME [KEY=VALUE]...", words parted by blanks, or from "[LABEL:] exec
/// COMMAND", which is another program (command_words.hpp), or one of OMPL (ompl_planner.hpp);
/// without a label its own words are one. Throws UsageError, which says what there is, for an
/// unknown name or setting, and for a command without {problem} or {solution} or whose program is
/// not there.
core::BenchmarkPlanner parse_planner(const std::string& given);

/// All of them; "all" stands for every planner there is. Throws UsageError, also when two would
/// have one label.
std::vector<core::BenchmarkPlanner> parse_planners(const std::vector<std::string>& texts);

/// The text logs that --ompl-log gives, one for each problem and direction of the plan; none where
/// the name is empty.
std::vector<std::filesystem::path> log_files(const core::BenchmarkPlan& plan,
                                             const std::string& name);

/// Throws UsageError when a planner's settings do not suit the body of a problem.
void require_usable(const core::BenchmarkPlan& plan);

/// A line on standard error for each setting that changes nothing for the body of a problem, or as
/// the other settings are; nothing with --quiet.
void warn_of_idle_settings(const CommandLine& command_line, const core::BenchmarkPlan& plan);

}  // namespace asv::tools
