#include "asv/io/trees_file.hpp"

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

#include "asv/io/atomic_file.hpp"
#include "asv/io/json_place.hpp"
#include "asv/io/parse_error.hpp"

namespace asv::io {

namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

constexpr int format_version = 1;
constexpr std::size_t longest_excerpt = 40;

std::string excerpt(const json& value) {
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > longest_excerpt) text = text.substr(0, longest_excerpt) + "...";
    return text;
}

/// What a message of the parser puts between single quotes: the token it speaks of.
std::string quoted(const std::string& message) {
    const std::size_t begin = message.find('\'') + 1;
    return message.substr(begin, message.rfind('\'') - begin);
}

/// One document with its text, so that every complaint can name a line and a column.
class Document {
  public:
    Document(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
        try {
            root_ = json::parse(text);
        } catch (const json::parse_error& error) {
            // The parser counts bytes from 1 and points behind the byte that it could not use.
            const std::size_t byte = error.byte == 0 ? 0 : error.byte - 1;
            const TextPlace place = place_of_offset(text, byte);
            const std::string found = byte < text.size() ? std::string(1, text[byte]) : "the end";
            throw ParseError(name_, place.line, place.column, "JSON", found);
        } catch (const json::out_of_range& error) {
            const std::string number = quoted(error.what());
            const TextPlace place = place_of_offset(text, std::min(text.find(number), text.size()));
            throw ParseError(name_, place.line, place.column, "a number that fits a double",
                             number);
        }
    }

    [[noreturn]] void fail(const Pointer& at, const std::string& expected) const {
        const std::string pointer = at.to_string();
        const TextPlace place = place_of_value(text_, pointer);
        const std::string found = root_.contains(at) ? excerpt(root_.at(at)) : "nothing";
        throw ParseError(name_, place.line, place.column,
                         expected + " at " + readable_path(pointer), found);
    }

    const json& array(const Pointer& at) const {
        if (!root_.contains(at) || !root_.at(at).is_array()) fail(at, "an array");
        return root_.at(at);
    }

    std::string text(const Pointer& at) const {
        if (!root_.contains(at) || !root_.at(at).is_string()) fail(at, "a string");
        return root_.at(at).get<std::string>();
    }

    std::int64_t integer(const Pointer& at, std::int64_t low, std::int64_t high) const {
        if (!root_.contains(at)) fail(at, "an integer");
        return integer(root_.at(at), at, low, high);
    }

    /// The value is handed in as well, since looking up a pointer for each of a million is slow.
    std::int64_t integer(const json& value, const Pointer& at, std::int64_t low,
                         std::int64_t high) const {
        const std::string expected =
            "an integer from " + std::to_string(low) + " to " + std::to_string(high);
        if (!value.is_number_integer()) fail(at, expected);
        const bool too_big =
            value.is_number_unsigned() &&
            value.get<std::uint64_t>() >
                static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
        if (too_big || value.get<std::int64_t>() < low || value.get<std::int64_t>() > high) {
            fail(at, expected);
        }
        return value.get<std::int64_t>();
    }

    geometry::Point point(const json& value, const Pointer& at) const {
        const bool pair =
            value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
        if (!pair) fail(at, "two numbers [x, y]");
        return {value[0].get<double>(), value[1].get<double>()};
    }

    bool has(const Pointer& at) const { return root_.contains(at); }

  private:
    std::string_view text_;
    std::string name_;
    json root_;
};

SearchTree read_tree(const Document& document, const Pointer& at) {
    SearchTree tree;
    tree.root = document.text(at / "root");
    const json& points = document.array(at / "points");
    tree.points.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        tree.points.push_back(document.point(points[i], at / "points" / i));
    }
    if (!document.has(at / "parents")) {
        tree.parents.assign(points.size(), -1);
        return tree;
    }
    const json& parents = document.array(at / "parents");
    if (parents.size() != points.size()) {
        document.fail(at / "parents", "as many numbers as there are points (" +
                                          std::to_string(points.size()) + ")");
    }
    const auto last = static_cast<std::int64_t>(points.size()) - 1;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        tree.parents.push_back(document.integer(parents[i], at / "parents" / i, -1, last));
    }
    return tree;
}

std::vector<std::array<std::size_t, 2>> read_edges(const Document& document,
                                                   const SearchTrees& trees) {
    const Pointer at("/edges");
    const json& edges = document.array(at);
    if (!edges.empty() && trees.trees.empty()) document.fail(at, "no edges without a tree");
    std::vector<std::array<std::size_t, 2>> result;
    result.reserve(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (!edges[i].is_array() || edges[i].size() != 2) {
            document.fail(at / i, "two indices [i, j]");
        }
        const auto last = static_cast<std::int64_t>(trees.trees[0].points.size()) - 1;
        const auto index = [&](std::size_t k) {
            return static_cast<std::size_t>(document.integer(edges[i][k], at / i / k, 0, last));
        };
        result.push_back({index(0), index(1)});
    }
    return result;
}

}  // namespace

SearchTrees parse_trees(std::string_view text, const std::string& name) {
    const Document document(text, name);
    document.integer(Pointer("/version"), format_version, format_version);
    SearchTrees result;
    result.planner = document.text(Pointer("/planner"));
    result.asv_count = static_cast<std::size_t>(
        document.integer(Pointer("/asv_count"), 1, std::numeric_limits<std::int32_t>::max()));
    const std::size_t count = document.array(Pointer("/trees")).size();
    for (std::size_t i = 0; i < count; ++i) {
        result.trees.push_back(read_tree(document, Pointer("/trees") / i));
    }
    if (document.has(Pointer("/edges"))) result.edges = read_edges(document, result);
    return result;
}

SearchTrees read_trees(const std::filesystem::path& file) {
    return parse_trees(read_file(file), file.string());
}

std::string format_trees(const SearchTrees& trees) {
    json document = {{"version", format_version},
                     {"planner", trees.planner},
                     {"asv_count", trees.asv_count},
                     {"trees", json::array()}};
    for (const SearchTree& tree : trees.trees) {
        json points = json::array();
        for (const geometry::Point& point : tree.points) points.push_back({point.x, point.y});
        document["trees"].push_back(
            {{"root", tree.root}, {"points", std::move(points)}, {"parents", tree.parents}});
    }
    if (!trees.edges.empty()) document["edges"] = trees.edges;
    return document.dump() + "\n";
}

void write_trees(const std::filesystem::path& file, const SearchTrees& trees) {
    write_file(file, format_trees(trees));
}

}  // namespace asv::io
