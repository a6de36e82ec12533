#include "io/benchmark/record/generated_name.hpp"

#include <sstream>

namespace asv::io {

std::string generated_name(const std::string& words) {
    return std::string(generate_word) + ' ' + words;
}

std::optional<std::vector<std::string>> generator_words(const std::string& file) {
    if (!file.starts_with(generate_word)) return std::nullopt;
    std::istringstream text(file.substr(generate_word.size()));
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    return words;
}

}  // namespace asv::io
