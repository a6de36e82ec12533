#include "io/text/json/limits.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/text/json/place.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {
namespace {

/// Behind the closing quote of the string that begins here, or the end of the text.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
    std::size_t at = begin + 1;
    while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2U : 1U;
    return std::min(at + 1, text.size());
}

[[noreturn]] void fail(std::string_view text, const std::string& name, std::size_t offset,
                       const std::string& expected, const std::string& found) {
    const TextPlace place = place_of_offset(text, offset);
    throw ParseError(name, place.line, place.column, expected, found);
}

/// What a string of JSON says, its quotes included in what is given.
std::string content_of(std::string_view quoted) {
    if (quoted.find('\\') == std::string_view::npos)
        return std::string(quoted.substr(1, quoted.size() - 2));
    return nlohmann::json::parse(quoted).get<std::string>();
}

}  // namespace

void require_modest_json(std::string_view text, const std::string& name) {
    std::size_t depth = 0, values = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"') {
            at = end_of_string(text, at);
            continue;
        }
        if (c == '[' || c == '{') {
            ++values;
            if (++depth > max_json_depth)
                fail(text, name, at,
                     "at most " + std::to_string(max_json_depth) + " brackets inside each other",
                     "one more");
        }
        if ((c == ']' || c == '}') && depth > 0) --depth;
        if (c == ',' && ++values > max_json_values)
            fail(text, name, at, "at most " + std::to_string(max_json_values) + " values", "more");
        ++at;
    }
}

void require_unique_members(std::string_view text, const std::string& name) {
    // The names so far of every object that is open; an array has none.
    std::vector<std::set<std::string>> open;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '[' || c == '{') open.emplace_back();
        if (c == ']' || c == '}') open.pop_back();
        if (c != '"') {
            ++at;
            continue;
        }
        const std::size_t begin = at;
        at = end_of_string(text, begin);
        const std::size_t next = text.find_first_not_of(" \t\r\n", at);
        const bool is_name = next != std::string_view::npos && text[next] == ':';
        if (!is_name) continue;
        const std::string member = content_of(text.substr(begin, at - begin));
        if (!open.back().insert(member).second)
            fail(text, name, begin, "each member once", "\"" + member + "\" again");
    }
}

}  // namespace asv::io
