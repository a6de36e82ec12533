#pragma once

#include <string>

namespace asv::io {

/// Appends the shortest decimal text that reads back to exactly this value. Precondition: finite.
void append_number(std::string& text, double value);

/// Whether it is one of 0 to 9, whatever the locale.
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace asv::io
