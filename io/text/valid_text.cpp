#include "io/text/valid_text.hpp"

#include <cstddef>

namespace asv::io {

namespace {

/// Of the character that begins here; 0 where none does.
std::size_t length_of(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80U) return 1;
    const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC2U || first > 0xF4U || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    // Not in the shortest form, halves of pairs, beyond the last character.
    const unsigned char second = byte(1);
    const bool bad = (first == 0xE0U && second < 0xA0U) || (first == 0xEDU && second > 0x9FU) ||
                     (first == 0xF0U && second < 0x90U) || (first == 0xF4U && second > 0x8FU);
    return bad ? 0 : length;
}

}  // namespace

std::string valid_text(std::string_view bytes) {
    std::string text;
    while (!bytes.empty()) {
        const std::size_t length = length_of(bytes);
        const auto first = static_cast<unsigned char>(bytes[0]);
        if (length == 0)
            text += "\uFFFD";
        else if (first < 0x20U || first == 0x7FU)
            text += ' ';
        else
            text += bytes.substr(0, length);
        bytes.remove_prefix(length == 0 ? 1 : length);
    }
    return text;
}

}  // namespace asv::io
