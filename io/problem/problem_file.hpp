#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/problem.hpp"

namespace asv::io {

/// Something that was understood but is not as the format says: "FILE:LINE: MESSAGE".
struct Warning {
    std::string file;
    std::size_t line = 0;
    std::string message;
};

/// A problem and what had to be forgiven to read it.
struct ProblemFile {
    core::Problem problem;
    std::vector<Warning> warnings;
    std::size_t start_line = 2;  ///< where the start stands in the file
    std::size_t goal_line = 3;   ///< where the goal does
};

/// Reads the classic format (line 1: n; lines 2, 3: start, goal; line 4: m; then m obstacles), or a
/// scenario (see scenario_file.hpp) where the file begins with '{'. Throws ParseError (not
/// understood) or FileError (not readable).
ProblemFile read_problem(const std::filesystem::path& file);

/// The classic format from text; name stands for the file in messages.
ProblemFile parse_problem(std::string_view text, const std::string& name);

/// Writes the classic format, whole or not at all; reads back to the same numbers.
/// Throws FileError.
void write_problem(const std::filesystem::path& file, const core::Problem& problem);

}  // namespace asv::io
