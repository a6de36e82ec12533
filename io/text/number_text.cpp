#include "io/text/number_text.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace asv::io {

void append_number(std::string& text, double value) {
    assert(std::isfinite(value));
    std::array<char, 32> buffer;  // the longest is "-2.2250738585072014e-308"
    const auto [last, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    assert(error == std::errc{});
    text.append(buffer.data(), last);
}

}  // namespace asv::io
