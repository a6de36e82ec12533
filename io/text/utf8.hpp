#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace asv::io {

struct Utf8Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  ///< 0 where the text does not begin with valid UTF-8
};

/// The character at the beginning of a text that is not empty, by RFC 3629: neither longer than it
/// need be, nor half of a surrogate pair, nor beyond U+10FFFF.
Utf8Character first_character(std::string_view text);

}  // namespace asv::io
