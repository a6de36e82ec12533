#pragma once

#include <optional>
#include <vector>

#include "io/benchmark/report.hpp"
#include "tools/bench/bench_arguments.hpp"
#include "tools/bench/records/journal.hpp"

namespace asv::tools {

/// What is to be done, as far as it is known.
struct BenchTask {
    io::BenchmarkReport report;                 ///< the plan, and the runs that there are already
    std::vector<io::BenchmarkSession> earlier;  ///< that these are from
    std::vector<core::RunPlace> missing;        ///< what is to be run
    std::optional<Journal> journal;
};

/// Reads the problems, or the files with earlier runs and the problems of what is missing there.
/// False where a problem cannot be used, which has been told. Throws UsageError, ParseError,
/// ReadError.
bool prepare(const CommandLine& command_line, const BenchArguments& arguments, FileRoles& roles,
             BenchTask& task);

/// Opens the journal, where there shall be one, and leaves out what it holds. Throws as Journal
/// does. Precondition: the task is prepared.
void resume(const BenchArguments& arguments, BenchTask& task);

}  // namespace asv::tools
