#pragma once

#include <string>
#include <string_view>

/// "[LABEL:] WORD ...", as planners and problems are given.

namespace asv::tools {

/// The words with one blank between them.
std::string tidied(const std::string& text);

/// Where the word stands in "[LABEL:] WORD..."; npos where it stands nowhere like that.
std::size_t begin_of(std::string_view word, const std::string& text);

/// Is there a character that would not be seen?
bool has_control_character(const std::string& text);

}  // namespace asv::tools
