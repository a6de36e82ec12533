#pragma once

#include <optional>

#include "core/solve/solve.hpp"
#include "io/problem/problem_file.hpp"
#include "tools/solve/arguments.hpp"
#include "tools/solve/run_watch.hpp"

/// What asv-solve tells of a run: on standard error, in the files of --stats, --certificate,
/// --trajectory and --trees, and by its exit code.

namespace asv::tools {

ExitCode exit_code(core::SolveStatus status);

void write_statistics(const SolveArguments& arguments, const core::Problem& problem,
                      const core::SolveResult& result);

/// The proof that there is no path, where there is one that can be written down; else a line on
/// standard error that says why there is none.
void write_certificate(const SolveArguments& arguments, const core::Problem& problem,
                       core::SolveStatus status);

/// The path in as short a time as the limits allow, which the validator's own code has passed;
/// returns how many seconds it takes. Precondition: the name tells the format, the limits are known
/// and the run has a solution. Throws std::logic_error when the validator rejects it (a bug).
double write_trajectory(const SolveArguments& arguments, const core::Problem& problem,
                        const core::SolveResult& result);

void write_trees(const SolveArguments& arguments, const core::SolveResult& result,
                 std::size_t asv_count);

/// One line on standard error, and one for a trajectory of so many seconds.
void report(const SolveArguments& arguments, const core::SolveResult& result,
            std::optional<double> duration = {});

/// "start is not valid: REASON".
std::string text_of(const core::InvalidEnd& end);

/// "FILE:LINE: start is not valid: REASON", one line for each.
void report_invalid_ends(const SolveArguments& arguments, const io::ProblemFile& file,
                         const core::InvalidEnds& invalid);

/// A line on standard error for each setting that changes nothing, with the reason; none with
/// --quiet.
void warn_of_idle_settings(const SolveArguments& arguments, const core::Problem& problem);

/// One line while it runs.
std::string progress_text(const core::SolveProgress& progress);

/// The last words of a run that is cut off while its main thread is still busy: the statistics,
/// where they are not there yet, and a line on standard error. status: of the run, where it has
/// come to one. Returns the exit code; ends the process with it where nobody reads the words.
int give_up(const SolveArguments& arguments, const CutOff& at, core::SolveStatus status);

}  // namespace asv::tools
