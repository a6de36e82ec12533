#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "asv/geometry/primitives.hpp"

/// The data behind BoxIndex; use that class instead.

namespace asv::geometry::detail {

/// Eight boxes side by side in single precision, each holding the original (rounded outwards). A
/// lane without a box is NaN, which no comparison accepts.
struct alignas(64) WideNode {
    static constexpr std::uint32_t width = 8;
    enum Side : std::uint32_t { low_x, low_y, high_x, high_y };
    std::array<std::array<float, width>, 4> side;
};

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
    std::uint32_t level;  ///< on level 0 the lanes are the boxes themselves
    std::uint32_t index;  ///< within its level
};

/// A flat hierarchy without pointers: the child in lane l of node i is node 8 i + l one level
/// below; on level 0 it is the box order[8 i + l]. The topmost level has one node, or none at all.
struct BoxTree {
    static constexpr std::uint32_t most_roots = 4;
    static constexpr std::uint32_t most_levels = 11;  ///< 8^11 > 2^32
    /// A depth-first search leaves at most seven siblings open on every level.
    static constexpr std::uint32_t most_open = most_roots + (WideNode::width - 1) * most_levels;

    std::vector<WideNode> nodes;
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t> level_begin;  ///< first node of every level, and the end of the last
    double reach = 0;                        ///< largest magnitude of a coordinate

    std::uint32_t levels() const { return static_cast<std::uint32_t>(level_begin.size()) - 1; }
    std::uint32_t node_count(std::uint32_t level) const {
        return level_begin[level + 1] - level_begin[level];
    }
    /// Where a search for all boxes begins: it skips a topmost node with few children.
    std::uint32_t search_level() const {
        const std::uint32_t top = levels() - 1;
        return top > 0 && node_count(top - 1) <= most_roots ? top - 1 : top;
    }
    const WideNode& node(NodeId id) const { return nodes[level_begin[id.level] + id.index]; }
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
    std::array<NodeId, BoxTree::most_open> open;
    std::array<std::uint32_t, WideNode::width> found;
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
