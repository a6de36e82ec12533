#include "tools/bench/labelled_text.hpp"

#include <algorithm>
#include <sstream>

namespace asv::tools {

std::string tidied(const std::string& text) {
    std::istringstream words(text);
    std::string result;
    for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
    return result;
}

std::size_t begin_of(std::string_view word, const std::string& text) {
    std::size_t begin = 0;
    while (true) {
        begin = text.find_first_not_of(' ', begin);
        if (begin == std::string::npos) return begin;
        if (text.compare(begin, word.size(), word) == 0) return begin;
        const std::size_t colon = text.find(':', begin);
        if (colon == std::string::npos) return colon;
        begin = colon + 1;
    }
}

bool has_control_character(const std::string& text) {
    return std::any_of(text.begin(), text.end(),
                       [](char c) { return static_cast<unsigned char>(c) < ' '; });
}

}  // namespace asv::tools
