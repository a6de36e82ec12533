#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asv::io {

/// Brackets inside each other beyond this many are refused.
inline constexpr std::size_t max_json_depth = 64;

/// Documents of more values than this are refused: 16 to 150 bytes each when they are read.
inline constexpr std::size_t max_json_values = 20'000'000;

/// Throws ParseError when the text nests deeper or has more values than may be; looks at brackets,
/// commas and quotes alone, so the text need not be JSON.
void require_modest_json(std::string_view text, const std::string& name);

/// Throws ParseError when an object of the text has a member twice, however its name is escaped.
/// Precondition: text is a well-formed JSON document.
void require_unique_members(std::string_view text, const std::string& name);

}  // namespace asv::io
