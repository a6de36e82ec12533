#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "asv/geometry/primitives.hpp"

namespace asv::core::validation {

/// Finds the boxes near a place: a binary tree of bounding boxes, halved at the median of the
/// wider side. It holds the checker's own broad phase, so that the planner's cannot mislead it.
class BoxTree {
  public:
    /// Empty boxes are left out; the others keep their index. O(m log m).
    explicit BoxTree(std::span<const geometry::Box> boxes);

    /// Calls visit(index, box) for every box that may meet the region grown by reach; visit may
    /// reduce reach while the search goes on. Precondition: reach >= 0.
    template <typename Visit>
    void for_each_near(const geometry::Box& region, const double& reach, const Visit& visit) const {
        if (nodes_.empty()) return;
        // Halving at the median keeps the depth at 32 and what is pending below twice that.
        std::array<std::uint32_t, 64> pending;
        std::size_t count = 0;
        pending[count++] = 0;
        while (count > 0) {
            const std::uint32_t index = pending[--count];
            const Node& node = nodes_[index];
            if (!geometry::overlap(node.bounds, geometry::grown(region, reach))) continue;
            if (node.right != 0) {
                pending[count++] = node.right;
                pending[count++] = index + 1;
                continue;
            }
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                if (geometry::overlap(items_[i].box, geometry::grown(region, reach))) {
                    visit(items_[i].index, items_[i].box);
                }
            }
        }
    }

  private:
    struct Item {
        geometry::Box box;
        std::uint32_t index;
    };
    /// A leaf holds the items [begin, end); an inner node, whose right is not 0, is followed by
    /// its left child.
    struct Node {
        geometry::Box bounds;
        std::uint32_t begin;
        std::uint32_t end;
        std::uint32_t right;
    };

    void build(std::uint32_t begin, std::uint32_t end);

    std::vector<Item> items_;
    std::vector<Node> nodes_;
};

}  // namespace asv::core::validation
