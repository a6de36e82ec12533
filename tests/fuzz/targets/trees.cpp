#include "io/solution/trees_file.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

namespace {

void require_sound(const io::SearchTrees& trees) {
    for (const io::SearchTree& tree : trees.trees) {
        require(tree.parents.size() == tree.points.size(), "every node has a parent or is a root");
        const auto nodes = static_cast<std::int64_t>(tree.points.size());
        for (const std::int64_t parent : tree.parents)
            require(-1 <= parent && parent < nodes, "a parent is a node of the tree");
    }
    for (const auto& edge : trees.edges)
        for (const std::size_t node : edge)
            require(!trees.trees.empty() && node < trees.trees[0].points.size(),
                    "an edge joins two nodes");
}

}  // namespace

void trees(std::string_view input) {
    try {
        const io::SearchTrees read = io::parse_trees(input, "input");
        require_sound(read);
        require(io::parse_trees(io::format_trees(read), "written") == read,
                "trees that were written read back to the same numbers");
    } catch (const io::ParseError& error) {
        require_place_in(input, error);
    }
}

}  // namespace asv::fuzz
