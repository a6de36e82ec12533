#pragma once

#include "tools/common/command_line.hpp"
#include "tools/solve/arguments.hpp"

namespace asv::tools {

/// asv-solve --batch: answers the queries of a file about the world of the problem, in the order of
/// their lines. As many at once as --threads says, each with one thread, so that answers do not
/// depend on it. Returns bad_input where a query had an error, no where one has no path, else done.
/// Throws what the programs' command line tells of.
ExitCode answer_batch(const CommandLine& command_line, const SolveArguments& arguments);

}  // namespace asv::tools
