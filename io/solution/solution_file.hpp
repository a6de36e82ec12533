#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/path.hpp"
#include "io/text/warning.hpp"

namespace asv::io {

/// More positions (states times ASVs) than this are refused: 16 bytes each.
inline constexpr std::size_t max_path_positions = 50'000'000;

/// Reads a solution of asv_count ASVs (line 1: k and the cost; then k + 1 states); "-" is standard
/// input. As the reference tester does, it takes what it needs from the front of each line, and
/// k + 1 states; what else is there becomes a warning where a list is given. Throws ParseError (not
/// understood, fewer states, more than max_path_positions) or FileError.
core::Solution read_solution(const std::filesystem::path& file, std::size_t asv_count,
                             std::vector<Warning>* warnings = nullptr);

/// The same from text; name stands for the file in messages.
core::Solution parse_solution(std::string_view text, std::size_t asv_count, const std::string& name,
                              std::vector<Warning>* warnings = nullptr);

/// The file's text; numbers have the shortest digits that read back to the same number. Throws
/// std::invalid_argument when the path is empty.
std::string format_solution(const core::Solution& solution);

/// Writes the solution, whole or not at all. Throws FileError.
void write_solution(const std::filesystem::path& file, const core::Solution& solution);

}  // namespace asv::io
