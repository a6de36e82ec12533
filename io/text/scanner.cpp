#include "io/text/scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <system_error>
#include <utility>

namespace asv::io {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t longest_quote = 40;

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
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
        had_byte_order_mark_ = true;
    }
}

void Scanner::skip_blanks() {
    while (position_ != end_ && is_blank(*position_)) ++position_;
}

bool Scanner::at_line_end() {
    skip_blanks();
    return position_ == end_ || *position_ == '\n';
}

bool Scanner::at_end() const {
    return std::all_of(position_, end_, [](char c) { return is_blank(c) || c == '\n'; });
}

void Scanner::next_line() {
    position_ = std::find(position_, end_, '\n');
    if (position_ == end_) return;
    ++position_;
    ++line_;
    line_begin_ = position_;
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
    const bool whole_word = last == end_ || *last == '\n' || is_blank(*last);
    if (error != std::errc{} || !whole_word) return std::nullopt;
    if constexpr (std::floating_point<Number>) {
        if (!(std::abs(value) <= largest_number)) return std::nullopt;
    }
    position_ = last;
    return value;
}

std::optional<double> Scanner::number() {
    return take<double>();
}

std::optional<std::uint64_t> Scanner::count(std::uint64_t least) {
    const char* const before = position_;
    const std::optional<std::uint64_t> value = take<std::uint64_t>();
    if (value && *value >= least) return value;
    position_ = before;
    return std::nullopt;
}

std::string_view Scanner::word() const {
    const char* const last =
        std::find_if(position_, end_, [](char c) { return is_blank(c) || c == '\n'; });
    return {position_, last};
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
    const auto column = static_cast<std::size_t>(position_ - line_begin_) + 1;
    return {name_, line_, column, std::move(expected), std::move(found)};
}

}  // namespace asv::io
