#pragma once

#include <string>
#include <vector>

/// Pieces of text that the completions of all shells are made of.

namespace asv::tools::manual {

/// "asv-solve" as a part of the name of a function: "asv_solve".
std::string identifier(std::string name);

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
