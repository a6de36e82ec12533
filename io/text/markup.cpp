#include "io/text/markup.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace asv::io {

std::string escape_markup(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string with_two_decimals(std::string_view svg) {
    std::string result;
    result.reserve(svg.size());
    const char* at = svg.data();
    const char* const end = at + svg.size();
    while (at != end) {
        if (*at < '0' || *at > '9') {
            result += *at++;
            continue;
        }
        double value = 0;
        const char* const past = std::from_chars(at, end, value, std::chars_format::fixed).ptr;
        if (past - std::find(at, past, '.') > 3) {
            std::array<char, 32> shortest{};
            const auto written = std::to_chars(shortest.data(), shortest.data() + shortest.size(),
                                               std::round(value * 100) / 100);
            result.append(shortest.data(), written.ptr);
        } else {
            result.append(at, past);
        }
        at = past;
    }
    return result;
}

void append_filled(
    std::string& result, std::string_view page,
    const std::function<void(std::string& result, std::string_view key)>& append_part) {
    while (!page.empty()) {
        const std::size_t mark = std::min(page.find('@'), page.size());
        result += page.substr(0, mark);
        page.remove_prefix(mark);
        if (page.empty()) return;
        const std::size_t end = page.find('@', 1);
        append_part(result, page.substr(1, end - 1));
        page.remove_prefix(end + 1);
    }
}

std::string embeddable(std::string json) {
    for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
        json.replace(at, 1, "\\u003c");
    return json;
}

}  // namespace asv::io
