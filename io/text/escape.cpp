#include "io/text/escape.hpp"

#include <algorithm>
#include <cstdint>

namespace asv::io {
namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  ///< 0 when this is not UTF-8
};

constexpr std::uint32_t largest_code = 0x10FFFF;

/// The character at the beginning of a text that is not empty.
Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return {byte(0), 1};
    const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < bytes) return {};
    std::uint32_t code = byte(0) & (0xFFU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return {};
        code = code << 6U | (byte(i) & 0x3FU);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < least[bytes] || code > largest_code || surrogate) return {};
    return {code, bytes};
}

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
        const Character character = first_character(text);
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
