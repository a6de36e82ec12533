#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/benchmark/report.hpp"

/// A journal: the plan in its first line, then a line of JSON for every run that has ended
/// (docs/benchmark-files.md).

namespace asv::io {

/// Member "format" of the first line.
inline constexpr std::string_view journal_format = "asv-bench journal 1";

/// The first line, which begins the first session.
std::string journal_head(const BenchmarkReport& report);

/// Another session goes on with it.
std::string journal_session(const BenchmarkReport& report);

/// The session has come to an end by itself, and now knows its whole time.
std::string journal_session_end(const BenchmarkReport& report);

std::string journal_run(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run);

/// What a journal holds.
struct JournalText {
    /// Sorted runs; the session is all sessions together, each that was cut off with the time and
    /// the unit that it began with.
    BenchmarkReport report;
    std::size_t size =
        0;  ///< bytes of the lines that are whole; what comes behind is to be dropped
};

/// Does the text begin as a journal does, as far as it goes?
bool is_journal(std::string_view text);

/// None for a text in which not even the first line is whole. A last line that is not whole, or
/// that a loss of power has spoilt, is left out. Throws ParseError, which names the line of the
/// journal, for anything else that is not understood, and for a run that is there twice.
std::optional<JournalText> parse_journal(std::string_view text, const std::string& name);

}  // namespace asv::io
