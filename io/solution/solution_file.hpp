#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/model/path.hpp"

namespace asv::io {

/// Reads a solution of asv_count ASVs (line 1: k and the cost; then k + 1 states).
/// Throws ParseError (not understood, also when the number of states is not k + 1) or FileError.
core::Solution read_solution(const std::filesystem::path& file, std::size_t asv_count);

/// The same from text; name stands for the file in messages.
core::Solution parse_solution(std::string_view text, std::size_t asv_count,
                              const std::string& name);

/// Writes the solution with the shortest digits that read back to the same numbers; whole or not
/// at all. Throws FileError.
void write_solution(const std::filesystem::path& file, const core::Solution& solution);

}  // namespace asv::io
