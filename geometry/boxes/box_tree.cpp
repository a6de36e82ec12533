#include "geometry/boxes/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::geometry::detail {

namespace {

constexpr float float_infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t width = WideNode::width;

struct Entry {
    float x, y;  // the centre
    std::uint32_t index;
};

// Splits the entries at a multiple of the children's capacity nearest to the middle, until each
// part fits in one child, and then goes on within the children.
void sort_into_nodes(std::span<Entry> entries, std::size_t capacity, std::size_t least) {
    while (entries.size() <= capacity && capacity > least) capacity /= width;
    if (entries.size() <= capacity) return;
    const auto [left, right] = std::ranges::minmax(entries, {}, &Entry::x);
    const auto [bottom, top] = std::ranges::minmax(entries, {}, &Entry::y);
    const auto key = right.x - left.x >= top.y - bottom.y ? &Entry::x : &Entry::y;
    const std::size_t children = (entries.size() + capacity - 1) / capacity;
    const std::size_t middle = children / 2 * capacity;
    std::ranges::nth_element(entries, entries.begin() + static_cast<std::ptrdiff_t>(middle), {},
                             [key](const Entry& e) { return std::pair(e.*key, e.index); });
    sort_into_nodes(entries.first(middle), capacity, least);
    sort_into_nodes(entries.subspan(middle), capacity, least);
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr Box no_box{{nan, nan}, {nan, nan}};

/// A box in single precision that holds the original.
using FloatBox = std::array<float, 4>;

constexpr FloatBox nothing{float_infinity, float_infinity, -float_infinity, -float_infinity};

FloatBox rounded_out(const Box& box) {
    return {rounded_down(box.low.x), rounded_down(box.low.y), rounded_up(box.high.x),
            rounded_up(box.high.y)};
}

void set_lane(WideNode& node, std::size_t lane, const FloatBox& box) {
    for (std::size_t side = 0; side < box.size(); ++side) node.side[side][lane] = box[side];
}

FloatBox lane_of(const WideNode& node, std::size_t lane) {
    FloatBox box{};
    for (std::size_t side = 0; side < box.size(); ++side) box[side] = node.side[side][lane];
    return box;
}

WideNode empty_node() {
    WideNode node;
    for (auto& side : node.side) side.fill(nan);
    return node;
}

// These pass over the NaN of lanes without a box.
void include(FloatBox& hull, const FloatBox& box) {
    for (const BoxSide side : {low_x, low_y})
        hull[side] = box[side] < hull[side] ? box[side] : hull[side];
    for (const BoxSide side : {high_x, high_y})
        hull[side] = box[side] > hull[side] ? box[side] : hull[side];
}

void add_boxes(BoxTree& tree, std::span<const Box> boxes, std::size_t lanes) {
    const std::size_t groups = (tree.order.size() + lanes - 1) / lanes;
    tree.boxes.reserve(groups * lanes);
    for (const std::uint32_t index : tree.order) {
        const Box& box = tree.boxes.emplace_back(boxes[index]);
        for (const double v : {box.low.x, box.low.y, box.high.x, box.high.y}) {
            tree.largest_coordinate = std::max(tree.largest_coordinate, std::fabs(v));
        }
    }
    tree.boxes.resize(groups * lanes, no_box);
}

// Level 1 over the boxes themselves.
void add_nodes(BoxTree& tree) {
    tree.nodes.assign(tree.boxes.size() / width, empty_node());
    for (std::size_t i = 0; i < tree.order.size(); ++i) {
        set_lane(tree.nodes[i / width], i % width, rounded_out(tree.boxes[i]));
    }
}

// So far above the highest side of a leaf that max_steps of its steps reach it. With e = 2^-24 the
// roundings here, of the step and of finding a side from it take less than 6 e (|low| + |high|),
// which the last terms make good.
float widened(float low, float high) {
    const float extent = (high - low) * (256 / Leaf::max_steps);
    return low + extent + ((std::fabs(low) + std::fabs(high)) * 0x1p-21F + 0x1p-90F);
}

// The number of steps nearest to the value from which it is found not above it (below), or not
// below it, fused or not. Where coordinates overflow, what is found may also be NaN.
std::uint8_t steps_to(float value, float low, float step, bool below) {
    const auto beyond = [&](float steps) {
        const float fused = std::fma(steps, step, low), rounded = steps * step + low;
        return below ? std::max(fused, rounded) > value : std::min(fused, rounded) < value;
    };
    const float quotient = (value - low) / step;
    float steps = quotient >= 0 ? std::min(std::floor(quotient), Leaf::max_steps) : 0;
    if (below) {
        while (steps > 0 && beyond(steps)) --steps;
    } else {
        while (steps < Leaf::max_steps && beyond(steps)) ++steps;
    }
    return static_cast<std::uint8_t>(steps);
}

void fill_leaf(Leaf& leaf, const LeafFrame& frame, std::span<const FloatBox> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const FloatBox& box = boxes[i];
        leaf.side[low_x][i] = steps_to(box[low_x], frame.x, frame.step_x, true);
        leaf.side[low_y][i] = steps_to(box[low_y], frame.y, frame.step_y, true);
        leaf.side[high_x][i] = steps_to(box[high_x], frame.x, frame.step_x, false);
        leaf.side[high_y][i] = steps_to(box[high_y], frame.y, frame.step_y, false);
    }
}

// The leaves and level 1 over them.
void add_leaves(BoxTree& tree) {
    const std::size_t leaves = tree.boxes.size() / Leaf::width;
    tree.leaves.assign(leaves, {});
    tree.nodes.assign((leaves + width - 1) / width, empty_node());
    std::array<FloatBox, Leaf::width> boxes;
    for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
        const std::size_t first = leaf * Leaf::width;
        const std::size_t count = std::min<std::size_t>(Leaf::width, tree.order.size() - first);
        FloatBox hull = nothing;
        for (std::size_t i = 0; i < count; ++i) {
            boxes[i] = rounded_out(tree.boxes[first + i]);
            include(hull, boxes[i]);
        }
        hull[high_x] = widened(hull[low_x], hull[high_x]);
        hull[high_y] = widened(hull[low_y], hull[high_y]);
        set_lane(tree.nodes[leaf / width], leaf % width, hull);
        const LeafFrame frame = tree.frame(static_cast<std::uint32_t>(leaf));
        fill_leaf(tree.leaves[leaf], frame, std::span(boxes).first(count));
    }
}

void add_level(BoxTree& tree) {
    const std::size_t begin = tree.level_begin.end()[-2];
    const std::size_t end = tree.level_begin.back();
    tree.nodes.resize(end + (end - begin + width - 1) / width, empty_node());
    for (std::size_t i = 0; i < end - begin; ++i) {
        FloatBox hull = nothing;
        for (std::size_t lane = 0; lane < width; ++lane) {
            include(hull, lane_of(tree.nodes[begin + i], lane));
        }
        set_lane(tree.nodes[end + i / width], i % width, hull);
    }
    tree.level_begin.push_back(static_cast<std::uint32_t>(tree.nodes.size()));
}

}  // namespace

BoxTree build_box_tree(std::span<const Box> boxes) {
    std::vector<Entry> entries;
    entries.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (is_empty(boxes[i])) continue;
        entries.push_back({static_cast<float>(boxes[i].low.x / 2 + boxes[i].high.x / 2),
                           static_cast<float>(boxes[i].low.y / 2 + boxes[i].high.y / 2),
                           static_cast<std::uint32_t>(i)});
    }
    const bool with_leaves = entries.size() > BoxTree::max_without_leaves;
    const std::size_t lanes = with_leaves ? Leaf::width : width;
    std::size_t capacity = lanes;
    while (capacity < entries.size()) capacity *= width;
    sort_into_nodes(entries, capacity, lanes);

    BoxTree tree;
    tree.order.reserve(entries.size());
    for (const Entry& entry : entries) tree.order.push_back(entry.index);
    add_boxes(tree, boxes, lanes);
    with_leaves ? add_leaves(tree) : add_nodes(tree);
    tree.level_begin = {0, static_cast<std::uint32_t>(tree.nodes.size())};
    while (tree.node_count(tree.levels() - 1) > 1) add_level(tree);
    return tree;
}

}  // namespace asv::geometry::detail
