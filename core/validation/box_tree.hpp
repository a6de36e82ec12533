#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::core::validation {

/// The points within some distance of a segment, or a little more: what is left of the plane after
/// cutting along the axes and along the segment.
class Neighbourhood {
  public:
    explicit Neighbourhood(const geometry::Segment& segment);

    /// False only when the box is farther from the segment than the radius. Precondition: radius >=
    /// 0, box not empty.
    bool may_be_within(const geometry::Box& box, double radius) const;

  private:
    geometry::Point origin_;
    geometry::Point normal_;  ///< of length 1; 0 when the segment is a point
    geometry::Box bounds_;
};

/// Finds the boxes near a segment: a binary tree of bounding boxes, halved at the median of the
/// axis along which the boxes' middles are farther apart. It is the checker's own broad phase, so
/// that the planner's cannot mislead it.
class BoxTree {
  public:
    /// Empty boxes are left out; the others keep their index. O(m log m).
    explicit BoxTree(std::span<const geometry::Box> boxes);

    /// Calls visit(index, box) for every box within the radius of the segment, and for some others;
    /// visit may reduce the radius while the search goes on. Precondition: radius >= 0.
    template <typename Visit>
    void for_each_near(const geometry::Segment& segment, const double& radius,
                       const Visit& visit) const {
        if (nodes_.empty()) return;
        const Neighbourhood near(segment);
        // Halving at the median keeps the depth at 32 and what is pending below twice that.
        std::array<std::uint32_t, 64> pending;
        std::size_t count = 0;
        pending[count++] = 0;
        while (count > 0) {
            const std::uint32_t index = pending[--count];
            const Node& node = nodes_[index];
            if (!near.may_be_within(node.bounds, radius)) continue;
            if (node.right != 0) {
                pending[count++] = node.right;
                pending[count++] = index + 1;
                continue;
            }
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                if (near.may_be_within(items_[i].box, radius))
                    visit(items_[i].index, items_[i].box);
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

    /// The middle of a box and its index.
    struct Entry {
        float x, y;
        std::uint32_t index;
    };

    /// Appends the nodes and items of these entries, at least one.
    void build(std::span<const geometry::Box> boxes, std::span<Entry> entries);

    std::vector<Item> items_;
    std::vector<Node> nodes_;
};

}  // namespace asv::core::validation
