#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/text/json/place.hpp"
#include "io/text/warning.hpp"

namespace asv::io {

/// A JSON text that was read, and the complaints about what stands in it. Every ParseError from
/// here names line, column and JSON path: "FILE:3:17: expected an array at trees[0].points, found
/// 7".
class JsonDocument {
  public:
    using Json = nlohmann::json;
    using Pointer = Json::json_pointer;

    /// Keeps a view of the text. Throws ParseError when it is not JSON, nests too deep or holds too
    /// much (json_limits.hpp), or has a member twice. A byte order mark is stepped over.
    JsonDocument(std::string_view text, std::string name);

    [[noreturn]] void fail(const Pointer& at, const std::string& expected) const;

    bool has(const Pointer& at) const { return root_.contains(at); }
    bool is_null(const Pointer& at) const { return has(at) && root_.at(at).is_null(); }
    bool is_object(const Pointer& at) const { return has(at) && root_.at(at).is_object(); }
    bool is_array(const Pointer& at) const { return has(at) && root_.at(at).is_array(); }
    bool is_number(const Pointer& at) const { return has(at) && root_.at(at).is_number(); }
    bool is_text(const Pointer& at) const { return has(at) && root_.at(at).is_string(); }

    /// Where the value there begins.
    TextPlace place(const Pointer& at) const;

    /// A warning about the value there: "MESSAGE at obstacles[3]".
    Warning warning(const Pointer& at, const std::string& message) const;

    /// Throws ParseError unless there is an object.
    void require_object(const Pointer& at) const;
    /// Likewise, unless it has all needed members and no others than these and the optional ones.
    void require_members(const Pointer& at, std::initializer_list<std::string_view> needed,
                         std::initializer_list<std::string_view> optional) const;

    /// The names of the object there, in the order of letters. Throws ParseError for anything else.
    std::vector<std::string> members(const Pointer& at) const;

    /// The value there; each throws ParseError when it is missing or something else.
    const Json& array(const Pointer& at) const;
    std::string text(const Pointer& at) const;
    double number(const Pointer& at) const;
    double number(const Pointer& at, double low, double high) const;
    std::int64_t integer(const Pointer& at, std::int64_t low, std::int64_t high) const;
    /// Any whole number that is not negative, to 2^64 - 1.
    std::uint64_t count(const Pointer& at) const;
    bool boolean(const Pointer& at) const;

    /// The same for a value that is at hand, which spares looking it up.
    std::int64_t integer(const Json& value, const Pointer& at, std::int64_t low,
                         std::int64_t high) const;

  private:
    std::string_view text_;
    std::string name_;
    Json root_;
};

}  // namespace asv::io
