#include "io/text/valid_text.hpp"

#include "io/text/utf8.hpp"

namespace asv::io {

std::string valid_text(std::string_view bytes) {
    std::string text;
    while (!bytes.empty()) {
        const Utf8Character character = first_character(bytes);
        if (character.bytes == 0) {
            text += "\uFFFD";
            bytes.remove_prefix(1);
            continue;
        }
        const bool control = character.code < 0x20 || character.code == 0x7F;
        text += control ? " " : bytes.substr(0, character.bytes);
        bytes.remove_prefix(character.bytes);
    }
    return text;
}

}  // namespace asv::io
