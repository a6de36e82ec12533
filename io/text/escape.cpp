#include "io/text/escape.hpp"

#include <algorithm>
#include <cstdint>

#include "io/text/utf8.hpp"

namespace asv::io {
namespace {

bool is_shown(std::uint32_t code) {
    struct Range {
        std::uint32_t first, last;
    };
    // Controls; what has no width or turns the direction of writing (Unicode 15, category Cf);
    // separators of lines; the byte order mark.
    constexpr Range hidden[] = {
        {0, 0x1F},        {0x7F, 0x9F},     {0xAD, 0xAD},     {0x61C, 0x61C},   {0x200B, 0x200F},
        {0x2028, 0x202E}, {0x2060, 0x206F}, {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}, {0xE0000, 0xE0FFF}};
    return std::none_of(std::begin(hidden), std::end(hidden), [code](const Range& range) {
        return range.first <= code && code <= range.last;
    });
}

}  // namespace

std::string escaped(std::string_view text) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    std::string result;
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
        const std::size_t bytes = std::max<std::size_t>(character.bytes, 1);
        if (character.bytes > 0 && is_shown(character.code)) {
            result += text.substr(0, bytes);
        } else {
            for (const char c : text.substr(0, bytes)) {
                const auto byte = static_cast<unsigned char>(c);
                result += {'\\', 'x', hex[byte >> 4U], hex[byte & 15U]};
            }
        }
        text.remove_prefix(bytes);
    }
    return result;
}

}  // namespace asv::io
