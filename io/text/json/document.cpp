#include "io/text/json/document.hpp"

#include <algorithm>
#include <limits>

#include "io/text/json/limits.hpp"
#include "io/text/number_text.hpp"
#include "io/text/parse_error.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {

namespace {

using Json = JsonDocument::Json;

constexpr std::size_t longest_excerpt = 40;

std::string excerpt(const Json& value) {
    std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > longest_excerpt) text = text.substr(0, longest_excerpt) + "...";
    return text;
}

/// What the parser has stopped at.
[[noreturn]] void fail_at(std::string_view text, const std::string& name, std::size_t byte) {
    const TextPlace place = place_of_offset(text, byte);
    const std::string found =
        byte < text.size() ? excerpt(Json(std::string(1, text[byte]))) : "the end of the file";
    throw ParseError(name, place.line, place.column, "JSON", found);
}

/// What a message of the parser puts between single quotes: the token it speaks of.
std::string token_in(const std::string& message) {
    const std::size_t begin = message.find('\'') + 1;
    return message.substr(begin, message.rfind('\'') - begin);
}

bool is_in(const Json& value, std::int64_t low, std::int64_t high) {
    if (!value.is_number_integer()) return false;
    const auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (value.is_number_unsigned() && value.get<std::uint64_t>() > most) return false;
    return value.get<std::int64_t>() >= low && value.get<std::int64_t>() <= high;
}

}  // namespace

JsonDocument::JsonDocument(std::string_view text, std::string name)
    : text_(text), name_(std::move(name)) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    text_ = text;
    require_modest_json(text, name_);
    try {
        root_ = Json::parse(text);
    } catch (const Json::parse_error& error) {
        // The parser counts bytes from 1 and points at the byte that it could not use.
        fail_at(text, name_, error.byte == 0 ? 0 : error.byte - 1);
    } catch (const Json::out_of_range& error) {
        const std::string number = token_in(error.what());
        const TextPlace place = place_of_offset(text, std::min(text.find(number), text.size()));
        throw ParseError(name_, place.line, place.column, "a number within the range of a double",
                         number);
    }
    // The parser takes a zero byte for the end of the text; what is behind it has not been read.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        fail_at(text, name_, zero);
    require_unique_members(text, name_);
}

void JsonDocument::fail(const Pointer& at, const std::string& expected) const {
    const std::string pointer = at.to_string();
    const TextPlace place = place_of_value(text_, pointer);
    const std::string found = has(at) ? excerpt(root_.at(at)) : "nothing";
    throw ParseError(name_, place.line, place.column, expected + " at " + readable_path(pointer),
                     found);
}

TextPlace JsonDocument::place(const Pointer& at) const {
    return place_of_value(text_, at.to_string());
}

Warning JsonDocument::warning(const Pointer& at, const std::string& message) const {
    const TextPlace found = place(at);
    return {name_, found.line, found.column, message + " at " + readable_path(at.to_string())};
}

void JsonDocument::require_object(const Pointer& at) const {
    if (!has(at) || !root_.at(at).is_object()) fail(at, "an object");
}

void JsonDocument::require_members(const Pointer& at,
                                   std::initializer_list<std::string_view> needed,
                                   std::initializer_list<std::string_view> optional) const {
    require_object(at);
    for (const std::string_view key : needed)
        if (!has(at / std::string(key))) fail(at / std::string(key), "a member");
    const auto is_in_list = [](const auto& list, const std::string& key) {
        return std::find(list.begin(), list.end(), key) != list.end();
    };
    for (const auto& [key, value] : root_.at(at).items()) {
        if (is_in_list(needed, key) || is_in_list(optional, key)) continue;
        std::string known;
        for (const auto& list : {needed, optional})
            for (const std::string_view name : list)
                known.append(known.empty() ? "" : ", ").append(name);
        fail(at / key, "no other members than " + known);
    }
}

std::vector<std::string> JsonDocument::members(const Pointer& at) const {
    require_object(at);
    std::vector<std::string> names;
    for (const auto& [key, value] : root_.at(at).items()) names.push_back(key);
    return names;
}

const Json& JsonDocument::array(const Pointer& at) const {
    if (!has(at) || !root_.at(at).is_array()) fail(at, "an array");
    return root_.at(at);
}

std::string JsonDocument::text(const Pointer& at) const {
    if (!has(at) || !root_.at(at).is_string()) fail(at, "a string");
    return root_.at(at).get<std::string>();
}

double JsonDocument::number(const Pointer& at) const {
    if (!has(at) || !root_.at(at).is_number()) fail(at, "a number");
    return root_.at(at).get<double>();
}

double JsonDocument::number(const Pointer& at, double low, double high) const {
    const double value = number(at);
    if (value >= low && value <= high) return value;
    if (low == std::numeric_limits<double>::min()) fail(at, "a number greater than 0");
    // With all their digits: the number that was found may be near.
    std::string expected = high >= largest_number ? "a number of at least " : "a number from ";
    append_number(expected, low);
    if (high < largest_number) {
        expected += " to ";
        append_number(expected, high);
    }
    fail(at, expected);
}

std::int64_t JsonDocument::integer(const Pointer& at, std::int64_t low, std::int64_t high) const {
    return integer(has(at) ? root_.at(at) : Json(), at, low, high);
}

std::uint64_t JsonDocument::count(const Pointer& at) const {
    if (!has(at) || !root_.at(at).is_number_unsigned())
        fail(at, "a whole number from 0 to 18446744073709551615");
    return root_.at(at).get<std::uint64_t>();
}

bool JsonDocument::boolean(const Pointer& at) const {
    if (!has(at) || !root_.at(at).is_boolean()) fail(at, "true or false");
    return root_.at(at).get<bool>();
}

std::int64_t JsonDocument::integer(const Json& value, const Pointer& at, std::int64_t low,
                                   std::int64_t high) const {
    if (!is_in(value, low, high)) {
        fail(at, low == high
                     ? "the integer " + std::to_string(low)
                     : "an integer from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return value.get<std::int64_t>();
}

}  // namespace asv::io
