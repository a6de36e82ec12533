#include "io/solution/trees_file.hpp"

#include <limits>

#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "io/text/json_document.hpp"

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
