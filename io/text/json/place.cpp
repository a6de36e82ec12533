#include "io/text/json/place.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace asv::io {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Walks over a document that is known to be well formed.
class Walker {
  public:
    explicit Walker(std::string_view text) : text_(text) { skip_blanks(); }

    std::size_t offset() const { return at_; }

    /// Moves to the begin of the member or element of the value here; false, without moving, when
    /// there is none.
    bool enter(std::string_view key) {
        const char kind = text_[at_];
        if (kind != '{' && kind != '[') return false;
        const std::size_t begin = at_;
        std::optional<std::size_t> found;
        std::size_t index = 0;
        step();
        while (text_[at_] != '}' && text_[at_] != ']') {
            std::string name = std::to_string(index++);
            if (kind == '{') {
                name = string_here();
                step();
            }
            if (name == key) found = at_;
            skip_value();
            if (text_[at_] == ',') step();
        }
        at_ = found.value_or(begin);
        return found.has_value();
    }

  private:
    void skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }

    void step() {
        ++at_;
        skip_blanks();
    }

    /// The raw text between the quotes; escapes stay as they are, the keys we know have none.
    std::string string_here() {
        const std::size_t begin = ++at_;
        while (text_[at_] != '"') at_ += text_[at_] == '\\' ? 2U : 1U;
        std::string content(text_.substr(begin, at_ - begin));
        step();
        return content;
    }

    void skip_value() {
        std::size_t depth = 0;
        do {
            const char c = text_[at_];
            if (c == '"') {
                string_here();
                continue;
            }
            if (c == '{' || c == '[') ++depth;
            if (c == '}' || c == ']') --depth;
            const bool scalar = std::string_view("{}[],:").find(c) == std::string_view::npos;
            if (scalar) {
                at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
                skip_blanks();
            } else {
                step();
            }
        } while (depth > 0);
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

std::vector<std::string_view> tokens(std::string_view pointer) {
    std::vector<std::string_view> parts;
    while (!pointer.empty()) {
        pointer.remove_prefix(1);
        const std::size_t end = std::min(pointer.find('/'), pointer.size());
        parts.push_back(pointer.substr(0, end));
        pointer.remove_prefix(end);
    }
    return parts;
}

bool is_index(std::string_view token) {
    return !token.empty() && token.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

TextPlace place_of_offset(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    TextPlace place;
    place.line += static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t newline = before.rfind('\n');
    place.column += newline == std::string_view::npos ? before.size() : before.size() - newline - 1;
    return place;
}

TextPlace place_of_value(std::string_view text, std::string_view pointer) {
    Walker walker(text);
    for (const std::string_view token : tokens(pointer)) {
        if (!walker.enter(token)) break;
    }
    return place_of_offset(text, walker.offset());
}

std::string readable_path(std::string_view pointer) {
    if (pointer.empty()) return "the document";
    std::string path;
    for (const std::string_view token : tokens(pointer)) {
        if (is_index(token)) {
            path.append("[").append(token).append("]");
        } else {
            if (!path.empty()) path += '.';
            path += token;
        }
    }
    return path;
}

}  // namespace asv::io
