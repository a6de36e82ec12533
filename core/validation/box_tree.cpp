#include "asv/core/validation/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::core::validation {
namespace {

using geometry::Box;

constexpr std::uint32_t leaf_size = 4;

Box around(const Box& a, const Box& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

}  // namespace

Neighbourhood::Neighbourhood(const geometry::Segment& segment)
    : origin_(segment.a), bounds_(geometry::bounds(segment)) {
    const double dx = segment.b.x - segment.a.x;
    const double dy = segment.b.y - segment.a.y;
    const double length = std::hypot(dx, dy);
    if (length > 0) normal_ = {-dy / length, dx / length};
}

bool Neighbourhood::may_reach(const Box& box, double reach) const {
    if (!geometry::overlap(box, geometry::grown(bounds_, reach))) return false;
    const double half_width = (box.high.x - box.low.x) / 2;
    const double half_height = (box.high.y - box.low.y) / 2;
    const double x = box.low.x + half_width - origin_.x;
    const double y = box.low.y + half_height - origin_.y;
    const double away = std::abs(normal_.x * x + normal_.y * y);
    const double shadow = std::abs(normal_.x) * half_width + std::abs(normal_.y) * half_height;
    // All terms are sums of few products with a normal of length 1, each wrong by a few half ulps
    // of the coordinates, of which this is more than ten times as much.
    const double size = std::abs(box.low.x) + std::abs(box.high.x) + std::abs(box.low.y) +
                        std::abs(box.high.y) + std::abs(origin_.x) + std::abs(origin_.y);
    const double slack = 64 * std::numeric_limits<double>::epsilon() * size;
    return !(away > shadow + reach + slack);
}

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
