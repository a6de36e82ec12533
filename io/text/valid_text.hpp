#pragma once

#include <string>
#include <string_view>

namespace asv::io {

/// The text with U+FFFD for each byte that is not of valid UTF-8 (RFC 3629), and blanks for control
/// characters: file names may hold any bytes, pictures can show valid text alone.
std::string valid_text(std::string_view bytes);

}  // namespace asv::io
