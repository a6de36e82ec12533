#include "io/solution/trees_file.hpp"

#include <charconv>
#include <limits>

#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "io/text/json/document.hpp"
#include "io/text/number_text.hpp"

namespace asv::io {

namespace {

using nlohmann::json;
using Pointer = JsonDocument::Pointer;

constexpr int format_version = 1;
SearchTree read_tree(const JsonDocument& document, const Pointer& at) {
    SearchTree tree;
    tree.root = document.text(at / "root");
    const json& points = document.array(at / "points");
    tree.points.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool pair = points[i].is_array() && points[i].size() == 2 &&
                          points[i][0].is_number() && points[i][1].is_number();
        if (!pair) document.fail(at / "points" / i, "two numbers [x, y]");
        tree.points.push_back({points[i][0].get<double>(), points[i][1].get<double>()});
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

std::vector<std::array<std::size_t, 2>> read_edges(const JsonDocument& document,
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

std::string quoted(const std::string& text) {
    return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

template <class Whole>
void append_whole(std::string& text, Whole value) {
    std::array<char, 24> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
}

/// "[a,b]", each element put down by append.
template <class List, class Append>
void append_list(std::string& text, const List& list, const Append& append) {
    char separator = '[';
    for (const auto& element : list) {
        text += separator;
        append(element);
        separator = ',';
    }
    text += list.empty() ? "[]" : "]";
}

}  // namespace

SearchTrees parse_trees(std::string_view text, const std::string& name) {
    const JsonDocument document(text, name);
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
    // Put together by hand: there may be millions of numbers, and the time limit is near.
    std::string text = "{\"version\":" + std::to_string(format_version) +
                       ",\"planner\":" + quoted(trees.planner) +
                       ",\"asv_count\":" + std::to_string(trees.asv_count) + ",\"trees\":[";
    for (const SearchTree& tree : trees.trees) {
        text += std::string(&tree == &trees.trees.front() ? "" : ",") +
                "{\"root\":" + quoted(tree.root) + ",\"points\":";
        append_list(text, tree.points, [&](const geometry::Point& point) {
            text += '[';
            append_number(text, point.x);
            text += ',';
            append_number(text, point.y);
            text += ']';
        });
        text += ",\"parents\":";
        append_list(text, tree.parents, [&](std::int64_t parent) { append_whole(text, parent); });
        text += '}';
    }
    text += ']';
    if (!trees.edges.empty()) {
        text += ",\"edges\":";
        append_list(text, trees.edges, [&](const std::array<std::size_t, 2>& edge) {
            text += '[';
            append_whole(text, edge[0]);
            text += ',';
            append_whole(text, edge[1]);
            text += ']';
        });
    }
    return text + "}\n";
}

void write_trees(const std::filesystem::path& file, const SearchTrees& trees) {
    write_file(file, format_trees(trees));
}

}  // namespace asv::io
