#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Problems that are no files: made anew from the words of asv-generate wherever they are wanted.
/// In place of the file, a plan and its records name the words.

namespace asv::io {

inline constexpr std::string_view generate_word = "generate:";

/// "generate: corridor -n 7" for "corridor -n 7".
std::string generated_name(const std::string& words);

/// The words of such a name; none for a file. One whose name begins like that is told by "./".
std::optional<std::vector<std::string>> generator_words(const std::string& file);

}  // namespace asv::io
