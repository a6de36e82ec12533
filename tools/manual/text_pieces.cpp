#include "tools/manual/text_pieces.hpp"

namespace asv::tools::manual {

std::string glued(std::initializer_list<std::string_view> parts) {
    std::string text;
    for (const std::string_view part : parts) text += part;
    return text;
}

std::string function_prefix(const std::string& program) {
    return glued({"_", replaced(program, "-", "_")});
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

std::string quoted(const std::string& text) {
    return glued({"'", replaced(text, "'", "'\\''"), "'"});
}

std::string quoted_for_fish(const std::string& text) {
    return glued({"'", replaced(replaced(text, "\\", "\\\\"), "'", "\\'"), "'"});
}

std::vector<std::string> without_dots(std::vector<std::string> endings) {
    for (std::string& ending : endings) ending = replaced(ending, ".", "");
    return endings;
}

}  // namespace asv::tools::manual
