#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/text/parse_error.hpp"

namespace asv::io {

/// Coordinates beyond this are refused: products of four of them still fit a double, so that no
/// later computation overflows.
inline constexpr double largest_number = 1e70;

/// Walks over a text of numbers in lines and knows where it is. Blanks are spaces, tabs, carriage
/// returns, vertical tabs and form feeds, so CRLF reads like LF; a line ends at LF or at the end
/// of the text. The text has to outlive the scanner.
class Scanner {
  public:
    /// name stands for the file in error messages. A UTF-8 byte order mark is stepped over.
    Scanner(std::string_view text, std::string name);

    const std::string& name() const { return name_; }
    bool had_byte_order_mark() const { return had_byte_order_mark_; }

    /// The current line, from 1.
    std::size_t line() const { return line_; }

    /// Is nothing but blanks left on this line? Steps over them.
    bool at_line_end();

    /// Is nothing but white space left in the text? Does not move.
    bool at_end() const;

    /// Goes to the beginning of the next line, or to the end of the text.
    void next_line();

    /// The next word of this line as a number, and steps over it; none, without stepping over it,
    /// when the line is at its end or the word is no decimal number of at most largest_number in
    /// size ("nan", "inf", "0x1", "1e", "0,5"). A leading plus sign is allowed.
    std::optional<double> number();

    /// The same for a whole number of at least the given size, without point and exponent.
    std::optional<std::uint64_t> count(std::uint64_t least);

    /// The next number, or an error saying that expected() was due.
    template <std::invocable Expected>
    double require_number(const Expected& expected) {
        if (const std::optional<double> value = number()) return *value;
        throw error(expected());
    }

    /// An error at the next word of this line, which is shown as what was found.
    ParseError error(std::string expected);

  private:
    void skip_blanks();
    std::string_view word() const;
    std::string describe_word() const;
    template <typename Number>
    std::optional<Number> take();

    const char* position_;
    const char* line_begin_;
    const char* end_;
    std::size_t line_ = 1;
    std::string name_;
    bool had_byte_order_mark_ = false;
};

}  // namespace asv::io
