#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

/// Pieces of text that manual pages and completions are made of.

namespace asv::tools::manual {

/// The parts behind each other. (GCC 12 warns falsely of a short literal + a string that a function
/// returns.)
std::string glued(std::initializer_list<std::string_view> parts);

/// What names of functions for a program begin with: "_asv_solve".
std::string function_prefix(const std::string& program);

/// The words with something between them.
std::string joined(const std::vector<std::string>& words, const std::string& between);

/// Replaces every occurrence.
std::string replaced(std::string text, const std::string& what, const std::string& by);

/// In single quotes, for bash and zsh; for fish.
std::string quoted(const std::string& text);
std::string quoted_for_fish(const std::string& text);

/// Endings without their dots: {".txt", ".json"} gives {"txt", "json"}.
std::vector<std::string> without_dots(std::vector<std::string> endings);

}  // namespace asv::tools::manual
