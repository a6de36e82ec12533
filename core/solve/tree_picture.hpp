#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::core {

/// Where a tree has its root; the nodes of a roadmap are all roots.
enum class TreeRoot { start, goal, roadmap };

/// "start", "goal", "roadmap".
std::string_view name(TreeRoot root);

/// A search tree as a picture shows it: where ASV 1, the tip of an arm or the point is at each
/// node, and the node's parent.
struct TreePicture {
    TreeRoot root = TreeRoot::start;
    std::vector<geometry::Point> points;  ///< workspace units
    std::vector<std::int64_t> parents;    ///< of each node; -1 for a root
};

}  // namespace asv::core
