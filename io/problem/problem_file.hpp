#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/problem.hpp"
#include "io/problem/reading.hpp"
#include "io/text/warning.hpp"

namespace asv::io {

/// A problem and what had to be forgiven to read it.
struct ProblemFile {
    core::Problem problem;
    std::vector<Warning> warnings;
    std::size_t start_line = 2;                    ///< where the start stands in the file
    std::size_t goal_line = 3;                     ///< where the goal does
    std::vector<std::filesystem::path> maps = {};  ///< the files that a scenario has named
    std::string unit = {};  ///< of a scenario's lengths, for people; empty where it says none
};

/// Reads the classic format (line 1: n; lines 2, 3: start, goal; line 4: m; then m obstacles), or a
/// scenario (see scenario_file.hpp) where the file begins with '{'; "-" is standard input. Whatever
/// the reference tester reads is read: the numbers that are needed from the front of each line, as
/// many lines as are needed; what else is there is a warning. Throws ParseError (not understood,
/// more ASVs or obstacles than max_asvs and max_obstacles) or FileError (not readable).
ProblemFile read_problem(const std::filesystem::path& file, const ReadOptions& options = {});

/// The classic format from text; name stands for the file in messages.
ProblemFile parse_problem(std::string_view text, const std::string& name,
                          const ReadOptions& options = {});

/// The classic format, which reads back to the same numbers.
std::string format_problem(const core::Problem& problem);

/// Writes the classic format, whole or not at all. Throws FileError.
void write_problem(const std::filesystem::path& file, const core::Problem& problem);

}  // namespace asv::io
