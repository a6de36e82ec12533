#include "io/text/scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "io/text/number_text.hpp"

namespace asv::io {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t longest_quote = 40;

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

constexpr bool ends_line(char c) {
    return c == '\n' || c == '\r';
}

/// The word in quotes, at most longest_quote bytes of it, bytes that are not printable as \xNN.
std::string quoted(std::string_view word) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    std::string text = "\"";
    for (const char c : word.substr(0, longest_quote)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7F) {
            text += c;
        } else {
            text += {'\\', 'x', hex[byte >> 4U], hex[byte & 15U]};
        }
    }
    return text + (word.size() > longest_quote ? "...\"" : "\"");
}

}  // namespace

Scanner::Scanner(std::string_view text, std::string name)
    : position_(text.data()),
      line_begin_(text.data()),
      end_(text.data() + text.size()),
      name_(std::move(name)) {
    if (text.starts_with(byte_order_mark)) {
        position_ += byte_order_mark.size();
        line_begin_ = position_;
        warn("byte order mark ignored");
    }
}

void Scanner::skip_blanks() {
    while (position_ != end_ && is_blank(*position_)) ++position_;
}

bool Scanner::at_line_end() {
    skip_blanks();
    return at_newline();
}

bool Scanner::at_end() const {
    return std::all_of(position_, end_, [](char c) { return is_blank(c) || ends_line(c); });
}

void Scanner::next_line() {
    position_ = std::find_if(position_, end_, ends_line);
    if (position_ == end_) return;
    // Any number of CRs before an LF: a file that was converted twice.
    const char* const past = std::find_if(position_, end_, [](char c) { return c != '\r'; });
    if (past != end_ && *past == '\n') {
        position_ = past + 1;
    } else {
        if (lone_returns_++ == 0) {
            first_return_line_ = line_;
            first_return_column_ = column();
        }
        ++position_;
    }
    ++line_;
    line_begin_ = position_;
}

std::string Scanner::rest_of_line() {
    if (at_line_end()) return {};
    std::string text = quoted(word());
    std::size_t more = 0;
    for (position_ += word().size(); !at_line_end(); position_ += word().size()) ++more;
    if (more > 0)
        text += " and " + std::to_string(more) + (more == 1 ? " more word" : " more words");
    return text;
}

void Scanner::warn(std::string message) {
    skip_blanks();
    warnings_.add({name_, line_, column(), std::move(message)});
}

std::vector<Warning> Scanner::take_warnings() {
    if (lone_returns_ > 0) {
        const std::string others =
            lone_returns_ == 1 ? "" : " (and " + std::to_string(lone_returns_ - 1) + " more lines)";
        warnings_.add({name_, first_return_line_, first_return_column_,
                       "a lone carriage return ends this line" + others});
        lone_returns_ = 0;
    }
    return warnings_.take();
}

std::optional<double> Scanner::underflown(const char* first, const char* last) {
    // from_chars says "out of range" for the very large and the very small alike.
    const std::string copy(first, last);
    const double value = std::strtod(copy.c_str(), nullptr);
    if (std::abs(value) > 1) return std::nullopt;
    warn(quoted(std::string_view(copy)) + " is too small for a number and counts as 0");
    return value;
}

template <typename Number>
std::optional<Number> Scanner::take() {
    if (at_line_end()) return std::nullopt;
    const char* first = position_;
    if (*first == '+') ++first;
    const char* const unsigned_part = first != end_ && *first == '-' ? first + 1 : first;
    // from_chars also reads "inf" and "nan", and a minus sign after our plus.
    if (unsigned_part == end_ || !(is_digit(*unsigned_part) || *unsigned_part == '.') ||
        unsigned_part > position_ + 1) {
        return std::nullopt;
    }
    Number value{};
    const auto [last, error] = std::from_chars(first, end_, value);
    const bool whole_word = last == end_ || ends_line(*last) || is_blank(*last);
    if (!whole_word) return std::nullopt;
    if constexpr (std::floating_point<Number>) {
        if (error == std::errc::result_out_of_range) {
            const std::optional<double> tiny = underflown(first, last);
            if (tiny) position_ = last;
            return tiny;
        }
    }
    if (error != std::errc{}) return std::nullopt;
    if constexpr (std::floating_point<Number>) {
        if (!(std::abs(value) <= largest_number)) return std::nullopt;
    }
    position_ = last;
    return value;
}

std::optional<double> Scanner::number() {
    return take<double>();
}

std::optional<std::uint64_t> Scanner::count(std::uint64_t least, std::uint64_t most) {
    const char* const before = position_;
    const std::optional<std::uint64_t> value = take<std::uint64_t>();
    if (value && *value >= least && *value <= most) return value;
    position_ = before;
    return std::nullopt;
}

std::string_view Scanner::word() const {
    const char* const last =
        std::find_if(position_, end_, [](char c) { return is_blank(c) || ends_line(c); });
    return {position_, static_cast<std::size_t>(last - position_)};
}

std::string Scanner::describe_word() const {
    const std::string_view next = word();
    std::string text = quoted(next);
    double value = 0;
    const auto [last, error] = std::from_chars(next.data(), next.data() + next.size(), value);
    if (last != next.data() + next.size()) return text;
    if (error == std::errc::result_out_of_range || std::abs(value) > largest_number) {
        text += " (out of range)";
    } else if (std::isnan(value)) {
        text += " (not a number)";
    }
    return text;
}

ParseError Scanner::error(std::string expected) {
    std::string found;
    if (!at_line_end()) {
        found = describe_word();
    } else {
        found = at_end() ? "end of file" : "end of line";
    }
    return {name_, line_, column(), std::move(expected), std::move(found)};
}

}  // namespace asv::io
