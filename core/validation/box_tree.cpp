#include "asv/core/validation/box_tree.hpp"

#include <algorithm>

namespace asv::core::validation {
namespace {

using geometry::Box;

constexpr std::uint32_t leaf_size = 4;

Box around(const Box& a, const Box& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
    items_.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!is_empty(boxes[i])) items_.push_back({boxes[i], static_cast<std::uint32_t>(i)});
    }
    if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()));
}

void BoxTree::build(std::uint32_t begin, std::uint32_t end) {
    Box bounds = items_[begin].box;
    for (std::uint32_t i = begin; i < end; ++i) bounds = around(bounds, items_[i].box);
    const std::size_t node = nodes_.size();
    nodes_.push_back({bounds, begin, end, 0});
    if (end - begin <= leaf_size) return;
    const bool wide = bounds.high.x - bounds.low.x > bounds.high.y - bounds.low.y;
    const auto middle_of = [wide](const Item& item) {
        return wide ? item.box.low.x + item.box.high.x : item.box.low.y + item.box.high.y;
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](const Item& a, const Item& b) { return middle_of(a) < middle_of(b); });
    build(begin, middle);
    nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
}

}  // namespace asv::core::validation
