#include "core/solve/stages/tree_pictures.hpp"

#include <utility>

namespace asv::core {

namespace {

std::vector<std::int64_t> parents(const Tree& tree) {
    std::vector<std::int64_t> parents;
    for (std::uint32_t node = 0; node < tree.size(); ++node) {
        const std::uint32_t parent = tree.parent(node);
        parents.push_back(parent == Tree::none ? -1 : static_cast<std::int64_t>(parent));
    }
    return parents;
}

}  // namespace

std::vector<TreePicture> draw_trees(const SearchResult& search, const SolveCall& call) {
    const bool roadmap = search.trees.size() == 1 && !search.edges.empty();
    std::vector<TreePicture> pictures;
    for (const Tree& tree : search.trees) {
        const TreeRoot end = pictures.empty() ? TreeRoot::start : TreeRoot::goal;
        pictures.push_back(
            {roadmap ? TreeRoot::roadmap : end, call.solver.places(tree), parents(tree)});
    }
    return call.frame.trees_back(std::move(pictures));
}

}  // namespace asv::core
