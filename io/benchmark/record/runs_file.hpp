#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// Reads what asv-bench has written, a file of --json or a journal of --resume; "-" is standard
/// input. Of its problems only what tables tell is known (record_reader.hpp). Throws ParseError or
/// ReadError.
BenchmarkReport read_runs(const std::filesystem::path& file);

/// The same from text; name stands for the file in messages.
BenchmarkReport parse_runs(std::string_view text, const std::string& name);

}  // namespace asv::io
