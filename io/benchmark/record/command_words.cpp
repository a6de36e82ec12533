#include "io/benchmark/record/command_words.hpp"

#include <stdexcept>

namespace asv::io {

namespace {

bool is_blank(char letter) {
    return letter == ' ' || letter == '\t';
}

std::string quoted(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t'\"") == std::string::npos) return word;
    // Either quote may stand between two of the other kind.
    std::string result = "'";
    for (const char letter : word) {
        if (letter == '\'')
            result += "'\"'\"'";
        else
            result += letter;
    }
    return result + "'";
}

const std::string& value_of(std::string_view name, const CommandValues& values) {
    if (name == "problem") return values.problem;
    if (name == "solution") return values.solution;
    if (name == "seed") return values.seed;
    if (name == "time") return values.time;
    throw std::invalid_argument("there is no placeholder {" + std::string(name) +
                                "}; there are {problem}, {solution}, {seed} and {time}, and {{ "
                                "and }} for braces");
}

}  // namespace

std::vector<std::string> split_command(std::string_view text) {
    std::vector<std::string> words;
    bool inside = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char letter = text[at];
        if (is_blank(letter)) {
            inside = false;
            continue;
        }
        if (!inside) words.emplace_back();
        inside = true;
        if (letter != '\'' && letter != '"') {
            words.back() += letter;
            continue;
        }
        const std::size_t end = text.find(letter, at + 1);
        if (end == std::string_view::npos)
            throw std::invalid_argument(std::string("a quote ") + letter + " is not closed");
        words.back() += text.substr(at + 1, end - at - 1);
        at = end;
    }
    return words;
}

std::string join_command(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : " ").append(quoted(word));
    return text;
}

std::string fill_in(std::string_view word, const CommandValues& values) {
    std::string result;
    while (!word.empty()) {
        const char letter = word[0];
        const bool brace = letter == '{' || letter == '}';
        if (!brace || (word.size() > 1 && word[1] == letter)) {
            result += letter;
            word.remove_prefix(brace ? 2 : 1);
            continue;
        }
        const std::size_t end = letter == '{' ? word.find('}') : std::string_view::npos;
        if (end == std::string_view::npos)
            throw std::invalid_argument(std::string("a brace ") + letter +
                                        " stands alone; write it twice for a brace");
        result += value_of(word.substr(1, end - 1), values);
        word.remove_prefix(end + 1);
    }
    return result;
}

}  // namespace asv::io
