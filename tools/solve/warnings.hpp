#pragma once

#include "io/problem/problem_file.hpp"
#include "tools/solve/arguments.hpp"

namespace asv::tools {

/// Lines on standard error for what is asked for in good order and yet is hardly meant: a step so
/// short that the path will have an enormous number of them, settings that change nothing.
/// Nothing with --quiet.
void warn_of_doubtful(const SolveArguments& arguments, const io::ProblemFile& file);

}  // namespace asv::tools
