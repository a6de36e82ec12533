#include "tools/manual/shell_text.hpp"

#include <algorithm>

namespace asv::tools::manual {

std::string identifier(std::string name) {
    std::ranges::replace(name, '-', '_');
    return name;
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
    return "'" + replaced(text, "'", "'\\''") + "'";
}

std::string quoted_for_fish(const std::string& text) {
    return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::vector<std::string> without_dots(std::vector<std::string> endings) {
    for (std::string& ending : endings) ending = replaced(ending, ".", "");
    return endings;
}

}  // namespace asv::tools::manual
