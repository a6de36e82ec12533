#include "asv/geometry/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::geometry::detail {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t width = WideNode::width;

struct Entry {
    float x, y;  // the centre
    std::uint32_t index;
};

// Splits the entries at a multiple of the children's capacity nearest to the middle, until each
// part fits in one child, and then goes on within the children.
void sort_into_nodes(std::span<Entry> entries, std::size_t capacity) {
    while (entries.size() <= capacity && capacity > width) capacity /= width;
    if (entries.size() <= capacity) return;
    const auto [left, right] = std::ranges::minmax(entries, {}, &Entry::x);
    const auto [bottom, top] = std::ranges::minmax(entries, {}, &Entry::y);
    const auto key = right.x - left.x >= top.y - bottom.y ? &Entry::x : &Entry::y;
    const std::size_t children = (entries.size() + capacity - 1) / capacity;
    const std::size_t middle = children / 2 * capacity;
    std::ranges::nth_element(entries, entries.begin() + static_cast<std::ptrdiff_t>(middle), {},
                             [key](const Entry& e) { return std::pair(e.*key, e.index); });
    sort_into_nodes(entries.first(middle), capacity);
    sort_into_nodes(entries.subspan(middle), capacity);
}

void set_lane(WideNode& node, std::size_t lane, float low_x, float low_y, float high_x,
              float high_y) {
    node.side[WideNode::low_x][lane] = low_x;
    node.side[WideNode::low_y][lane] = low_y;
    node.side[WideNode::high_x][lane] = high_x;
    node.side[WideNode::high_y][lane] = high_y;
}

WideNode empty_node() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    WideNode node;
    for (std::size_t lane = 0; lane < width; ++lane) set_lane(node, lane, nan, nan, nan, nan);
    return node;
}

// fmin and fmax pass over the NaN of lanes without a box.
void set_parent_lane(WideNode& parent, std::size_t lane, const WideNode& child) {
    float low_x = infinity, low_y = infinity, high_x = -infinity, high_y = -infinity;
    for (std::size_t i = 0; i < width; ++i) {
        low_x = std::fmin(low_x, child.side[WideNode::low_x][i]);
        low_y = std::fmin(low_y, child.side[WideNode::low_y][i]);
        high_x = std::fmax(high_x, child.side[WideNode::high_x][i]);
        high_y = std::fmax(high_y, child.side[WideNode::high_y][i]);
    }
    set_lane(parent, lane, low_x, low_y, high_x, high_y);
}

void add_leaves(BoxTree& tree, std::span<const Box> boxes) {
    const std::size_t leaves = (tree.order.size() + width - 1) / width;
    tree.nodes.assign(leaves, empty_node());
    for (std::size_t i = 0; i < tree.order.size(); ++i) {
        const Box& box = boxes[tree.order[i]];
        set_lane(tree.nodes[i / width], i % width, rounded_down(box.low.x), rounded_down(box.low.y),
                 rounded_up(box.high.x), rounded_up(box.high.y));
        for (const double v : {box.low.x, box.low.y, box.high.x, box.high.y}) {
            tree.reach = std::max(tree.reach, std::fabs(v));
        }
    }
    tree.level_begin = {0, static_cast<std::uint32_t>(leaves)};
}

void add_level(BoxTree& tree) {
    const std::size_t begin = tree.level_begin.end()[-2];
    const std::size_t end = tree.level_begin.back();
    tree.nodes.resize(end + (end - begin + width - 1) / width, empty_node());
    for (std::size_t i = 0; i < end - begin; ++i) {
        set_parent_lane(tree.nodes[end + i / width], i % width, tree.nodes[begin + i]);
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
    std::size_t capacity = width;
    while (capacity < entries.size()) capacity *= width;
    sort_into_nodes(entries, capacity);

    BoxTree tree;
    tree.order.reserve(entries.size());
    for (const Entry& entry : entries) tree.order.push_back(entry.index);
    add_leaves(tree, boxes);
    while (tree.node_count(tree.levels() - 1) > 1) add_level(tree);
    return tree;
}

}  // namespace asv::geometry::detail
