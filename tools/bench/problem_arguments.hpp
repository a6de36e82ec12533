#pragma once

#include <string>
#include <vector>

#include "core/benchmark/plan.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"

namespace asv::tools {

/// A problem as it is given: a file, or "[LABEL:] generate: FAMILY OPTIONS...", the words of
/// asv-generate.
struct ProblemArgument {
    std::string name;  ///< of a generated one: the label, else its words; empty for a file
    std::string file;  ///< or "generate: WORDS" (io/benchmark/record/generated_name.hpp)
};

/// Throws UsageError for a label or words that hold a control character.
ProblemArgument parse_problem_argument(const std::string& given);

/// The files among them, as inputs of this program.
void add_problem_roles(const std::vector<std::string>& problems, FileRoles& roles);

/// What to call the problems: those that have no name by that of their file, without folder and
/// ending where no other has it, else by the whole path. Throws UsageError when two would have one
/// name.
std::vector<std::string> problem_names(const std::vector<ProblemArgument>& arguments);

/// Reads or generates the problems and checks that start and goal of each are valid. Tells on
/// standard error everything that is wrong with any file. Returns false when there was something,
/// and the plan cannot be run. Warnings are told as those of asv-solve. Maps are added to the
/// roles. Throws UsageError for words that asv-generate does not take either.
bool read_problems(const CommandLine& command_line, const std::vector<std::string>& given,
                   const io::ReadOptions& reading, FileRoles& roles,
                   std::vector<core::BenchmarkProblem>& problems);

}  // namespace asv::tools
