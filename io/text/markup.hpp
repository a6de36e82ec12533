#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace asv::io {

/// The text with the five characters that XML and HTML reserve written as entities.
std::string escape_markup(std::string_view text);

/// The markup of an SVG with two decimals of every number that has more.
std::string with_two_decimals(std::string_view svg);

/// Appends the page with each @KEY@ of it replaced by what append_part(result, "KEY") appends; what
/// is put in is not looked at again. Precondition: no other @ is in the page.
void append_filled(
    std::string& result, std::string_view page,
    const std::function<void(std::string& result, std::string_view key)>& append_part);

/// JSON that can stand in a script element: no "</script>" or "<!--" comes out of a name.
std::string embeddable(std::string json);

}  // namespace asv::io
