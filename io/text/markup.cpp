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

}  // namespace asv::io
