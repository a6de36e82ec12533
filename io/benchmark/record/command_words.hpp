#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The command line of a planner that is another program. No shell reads it.

namespace asv::io {

/// Its words, parted by blanks. What stands between two ' or two " is taken as it is, blanks too,
/// and belongs to the word that it touches; nothing else has a meaning, a backslash neither. Throws
/// std::invalid_argument for a quote that is not closed.
std::vector<std::string> split_command(std::string_view text);

/// A text that split_command() makes these words of.
std::string join_command(const std::vector<std::string>& words);

/// What stands for the placeholders of a command.
struct CommandValues {
    std::string problem, solution;  ///< paths
    std::string seed;
    std::string time;  ///< seconds
};

/// The word with {problem}, {solution}, {seed} and {time} replaced; {{ and }} are braces. Throws
/// std::invalid_argument for any other brace.
std::string fill_in(std::string_view word, const CommandValues& values);

}  // namespace asv::io
