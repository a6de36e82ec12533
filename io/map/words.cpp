#include "io/map/words.hpp"

#include <algorithm>
#include <charconv>

#include "io/text/json/place.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t longest_quote = 20;

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// A word in quotes, unless it is none that a text would have.
std::string quoted(std::string_view word) {
    const std::string_view shown = word.substr(0, longest_quote);
    const bool text =
        std::all_of(shown.begin(), shown.end(), [](char c) { return c >= 0x20 && c < 0x7F; });
    return text ? "'" + std::string(shown) + "'" : "bytes that are no text";
}

}  // namespace

MapWords::MapWords(std::string_view text, const std::string& name, bool comments)
    : text_(text), name_(name), comments_(comments) {
    if (text.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

void MapWords::skip(std::size_t bytes) {
    at_ = std::min(at_ + bytes, text_.size());
}

void MapWords::fail(const std::string& expected) {
    skip_blanks();
    fail_here(expected);
}

void MapWords::fail_here(const std::string& expected) const {
    const TextPlace place = place_of_offset(text_, at_);
    const std::string_view found = next();
    std::string what = quoted(found);
    if (found.empty()) what = "the end of the line";
    if (at_ >= text_.size()) what = "the end of the file";
    throw ParseError(name_, place.line, place.column, expected, what);
}

bool MapWords::take(std::string_view word) {
    skip_blanks();
    if (next() != word) return false;
    at_ += word.size();
    return true;
}

std::uint64_t MapWords::number(const std::string& what, std::uint64_t low, std::uint64_t high) {
    skip_blanks();
    const std::string_view digits = next();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size() || value < low || value > high)
        fail_here(what + " (a whole number from " + std::to_string(low) + " to " +
                  std::to_string(high) + ")");
    at_ += digits.size();
    return value;
}

std::uint8_t MapWords::bit() {
    return one_of("01", "0 or 1") == '1';
}

char MapWords::one_of(std::string_view characters, const std::string& expected) {
    skip_blanks();
    if (at_ >= text_.size() || characters.find(text_[at_]) == std::string_view::npos)
        fail_here(expected);
    return text_[at_++];
}

bool MapWords::at_end() {
    skip_blanks();
    return at_ >= text_.size();
}

geometry::Grid MapWords::make_grid(std::uint64_t width, std::uint64_t height) const {
    if (width * height > max_map_cells)
        fail_here("at most " + std::to_string(max_map_cells) + " cells");
    geometry::Grid grid{static_cast<std::size_t>(width), static_cast<std::size_t>(height)};
    grid.cells.resize(grid.width * grid.height);
    return grid;
}

std::string_view MapWords::next() const {
    std::size_t end = at_;
    while (end < text_.size() && !is_blank(text_[end])) ++end;
    return text_.substr(at_, end - at_);
}

void MapWords::skip_blanks() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || (comments_ && text_[at_] == '#'))) {
        const bool comment = text_[at_] == '#';
        at_ = comment ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
    }
}

}  // namespace asv::io
