#pragma once

#include <string>
#include <string_view>

namespace asv::io {

/// The text as it may be shown on a terminal: every byte of a control character, of a character
/// that turns the direction of writing or takes no room, and every byte that is not UTF-8 becomes
/// \xNN. Everything else, a backslash too, stays as it is.
std::string escaped(std::string_view text);

}  // namespace asv::io
