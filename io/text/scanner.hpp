#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/text/parse_error.hpp"
#include "io/text/warning.hpp"

namespace asv::io {

/// Coordinates beyond this are refused: products of four of them still fit a double, so that no
/// later computation overflows.
inline constexpr double largest_number = 1e70;

/// Walks over a text of numbers in lines, knows where it is, and collects what it had to forgive.
/// Blanks are spaces, tabs, vertical tabs and form feeds; a line ends at LF, at CRLF, at a lone CR
/// (which is warned about) or at the end of the text. The text has to outlive the scanner.
class Scanner {
  public:
    /// name stands for the file in messages. A UTF-8 byte order mark is stepped over, with a
    /// warning.
    Scanner(std::string_view text, std::string name);

    const std::string& name() const { return name_; }

    /// The current line, from 1.
    std::size_t line() const { return line_; }

    /// Is nothing but blanks left on this line? Steps over them.
    bool at_line_end();

    /// Is nothing but white space left in the text? Does not move.
    bool at_end() const;

    /// Goes to the beginning of the next line, or to the end of the text.
    void next_line();

    /// The words that are left on this line, `"0.05" and 2 more words`; empty when there are none.
    std::string rest_of_line();

    /// Adds a warning about the next word of this line.
    void warn(std::string message);
    /// Likewise about the line as a whole.
    void warn_about_line(std::string message) {
        warnings_.add({name_, line_, 1, std::move(message)});
    }

    /// Steps to the next line; what is left on this one is warned about: "ignored after AFTER:
    /// ...".
    template <std::invocable After>
    void leave_line(const After& after) {
        if (!at_line_end()) {
            const std::size_t first = column();
            warnings_.add(
                {name_, line_, first, "ignored after " + after() + ": " + rest_of_line()});
        }
        next_line();
    }

    /// All that was forgiven so far; each is told once.
    std::vector<Warning> take_warnings();

    /// The next word of this line as a number, and steps over it; none, without stepping over it,
    /// when the line is at its end or the word is no decimal number of at most largest_number in
    /// size ("nan", "inf", "0x1", "1e", "0,5"). A leading plus sign is allowed. What is too small
    /// for a double ("1e-400") is 0, with a warning.
    std::optional<double> number();

    /// The same for a whole number from least to most, without point and exponent.
    std::optional<std::uint64_t> count(std::uint64_t least, std::uint64_t most);

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
    bool at_newline() const {
        return position_ == end_ || *position_ == '\n' || *position_ == '\r';
    }
    std::size_t column() const { return static_cast<std::size_t>(position_ - line_begin_) + 1; }
    std::string_view word() const;
    std::optional<double> underflown(const char* first, const char* last);
    std::string describe_word() const;
    template <typename Number>
    std::optional<Number> take();

    const char* position_;
    const char* line_begin_;
    const char* end_;
    std::size_t line_ = 1;
    std::string name_;
    WarningList warnings_;
    std::size_t lone_returns_ = 0;
    std::size_t first_return_line_ = 0, first_return_column_ = 0;
};

}  // namespace asv::io
