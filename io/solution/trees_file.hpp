#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::io {

/// One search tree, or the nodes of a roadmap, seen through ASV 1 of every node.
struct SearchTree {
    std::string root;                     ///< "start", "goal" or "roadmap"
    std::vector<geometry::Point> points;  ///< where ASV 1 stands in each node
    std::vector<std::int64_t> parents;    ///< index into points, -1 for a root; as long as points
    friend bool operator==(const SearchTree&, const SearchTree&) = default;
};

/// What a planner has explored, for looking at: the trees it has grown, or its roadmap.
struct SearchTrees {
    std::string planner;
    std::size_t asv_count = 0;
    std::vector<SearchTree> trees;
    /// Only for a roadmap: pairs of indices into trees[0].points.
    std::vector<std::array<std::size_t, 2>> edges;
    friend bool operator==(const SearchTrees&, const SearchTrees&) = default;
};

/// Reads {"version": 1, "planner", "asv_count", "trees": [{"root", "points", "parents"}], "edges"}.
/// "edges" may be absent, and so may "parents" (then every node is a root). Throws ParseError,
/// which names the place by line, column and JSON path (trees[0].parents[3]), or ReadError.
SearchTrees read_trees(const std::filesystem::path& file);

/// The same from text; name stands for the file in messages.
SearchTrees parse_trees(std::string_view text, const std::string& name);

/// The file's text; numbers have the shortest digits that read back to the same value.
/// Precondition: all coordinates finite.
std::string format_trees(const SearchTrees& trees);

/// Writes the file, whole or not at all. Throws WriteError.
void write_trees(const std::filesystem::path& file, const SearchTrees& trees);

}  // namespace asv::io
