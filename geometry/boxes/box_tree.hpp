#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

/// The data behind BoxIndex; use that class instead.

namespace asv::geometry::detail {

/// The sides of a box in the order in which nodes and leaves keep them.
enum BoxSide : std::uint32_t { low_x, low_y, high_x, high_y };

/// Eight boxes side by side in single precision, each round a node or a leaf one level below or
/// round one of the boxes asked about (rounded outwards). A lane without a box is NaN, which no
/// comparison accepts.
struct alignas(64) WideNode {
    static constexpr std::uint32_t width = 8;
    std::array<std::array<float, width>, 4> side;
};

/// Sixteen boxes in one line of cache, each side as a number of steps from the low corner of the
/// leaf (rounded outwards): among many boxes the waits for memory are what a search costs. Lanes
/// without a box hold anything.
struct alignas(64) Leaf {
    static constexpr std::uint32_t width = 16;
    static constexpr float max_steps = 255;
    std::array<std::array<std::uint8_t, width>, 4> side;
};

/// What the steps of a leaf refer to: the low corner and the step along x and y.
struct LeafFrame {
    float x, y, step_x, step_y;
};

/// The frame of the leaf whose box is in that lane of the node above. A step is a 256th of that
/// box, which is widened accordingly, so that max_steps of them reach the leaf's highest side.
inline LeafFrame leaf_frame(const WideNode& parent, std::uint32_t lane) {
    const float x = parent.side[low_x][lane], y = parent.side[low_y][lane];
    return {x, y, (parent.side[high_x][lane] - x) * 0x1p-8F,
            (parent.side[high_y][lane] - y) * 0x1p-8F};
}

/// For every byte the numbers of its set bits, the lowest first.
inline constexpr auto set_bits = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte) {
        std::size_t count = 0;
        for (std::uint8_t bit = 0; bit < 8; ++bit) {
            if ((byte >> bit & 1) != 0) table[byte][count++] = bit;
        }
    }
    return table;
}();

struct NodeId {
    std::uint32_t level;  ///< the leaves are level 0
    std::uint32_t index;  ///< within its level
};

/// A flat hierarchy without pointers: the child in lane l of node i is node 8 i + l one level
/// below. The topmost level has one node, or none at all. Below level 1 are leaves, lane l of leaf
/// i being box 16 i + l; or there are none, and lane l of node i is box 8 i + l itself: that is
/// less work while all of it stays in a nearby cache.
struct BoxTree {
    static constexpr std::size_t max_without_leaves = 1 << 15;
    static constexpr std::uint32_t max_roots = 2;
    static constexpr std::uint32_t max_levels = 11;  ///< 8^11 > 2^32
    /// A depth-first search leaves at most seven siblings open on every level.
    static constexpr std::uint32_t max_open = max_roots + (WideNode::width - 1) * max_levels;

    std::vector<Leaf> leaves;
    std::vector<Box> boxes;            ///< those of all lanes in turn; NaN where there is none
    std::vector<std::uint32_t> order;  ///< their numbers, without those of lanes without a box
    std::vector<WideNode> nodes;
    std::vector<std::uint32_t> level_begin;  ///< first node of every level from 1 on, and the end
    double largest_coordinate = 0;           ///< in magnitude

    /// How many levels there are, with that of the leaves.
    std::uint32_t levels() const { return static_cast<std::uint32_t>(level_begin.size()); }
    /// Precondition: 1 <= level < levels().
    std::uint32_t node_count(std::uint32_t level) const {
        return level_begin[level] - level_begin[level - 1];
    }
    /// Where a search for all boxes begins: it skips a topmost node with few children.
    std::uint32_t search_level() const {
        const std::uint32_t top = levels() - 1;
        return top > 1 && node_count(top - 1) <= max_roots ? top - 1 : top;
    }
    /// Precondition: 1 <= id.level < levels().
    const WideNode& node(NodeId id) const { return nodes[level_begin[id.level - 1] + id.index]; }
    LeafFrame frame(std::uint32_t leaf) const {
        return leaf_frame(nodes[leaf / WideNode::width], leaf % WideNode::width);
    }
};

/// What a box has to reach to be found, in single precision and rounded so that none is lost: a
/// region, and an interval on the axis along a unit normal (for a region alone, the zero normal).
struct BoxQuery {
    float low_x, low_y, high_x, high_y;
    float normal_x, normal_y, normal_low, normal_high;
};

/// A depth-first search that can be interrupted: the nodes still to open and the last findings.
struct BoxSearch {
    BoxQuery query;
    std::uint32_t open_count = 0;
    std::array<NodeId, BoxTree::max_open> open;
    std::array<std::uint32_t, Leaf::width> found;
};

/// Sorts the boxes that are not empty by median splits from the top down, so that every node but
/// the last of its level is full (the overlap-minimising packing of Lee and Lee, 2003).
/// Time O(m log m). Preconditions: finite coordinates, fewer than 2^32 boxes.
BoxTree build_box_tree(std::span<const Box> boxes);

/// A float that is not above the value and close to it. Branchless, as queries wait for it:
/// conversion and subtraction err by at most half an ulp each, 2^-22 |f| is at least two ulps of a
/// normal number, and 2^-60 covers the others without bringing subnormal numbers into play.
inline float rounded_down(double value) {
    const float f = static_cast<float>(std::min<double>(value, std::numeric_limits<float>::max()));
    return f - (std::fabs(f) * 0x1p-22F + 0x1p-60F);
}

/// A float that is not below the value, likewise.
inline float rounded_up(double value) {
    return -rounded_down(-value);
}

}  // namespace asv::geometry::detail
