#pragma once

#include <string>
#include <string_view>

namespace asv::io {

/// The text with the five characters that XML and HTML reserve written as entities.
std::string escape_markup(std::string_view text);

/// The markup of an SVG with two decimals of every number that has more.
std::string with_two_decimals(std::string_view svg);

}  // namespace asv::io
