#include "core/validation/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/elementary/functions.hpp"

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
    const double length = elementary::hypot(dx, dy);
    if (length > 0) normal_ = {-dy / length, dx / length};
}

bool Neighbourhood::may_be_within(const Box& box, double radius) const {
    if (!geometry::overlap(box, geometry::grown(bounds_, radius))) return false;
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
    return !(away > shadow + radius + slack);
}

BoxTree::BoxTree(std::span<const Box> boxes) {
    std::vector<Entry> entries;
    entries.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (is_empty(boxes[i])) continue;
        const auto& [low, high] = boxes[i];
        entries.push_back({static_cast<float>(low.x / 2 + high.x / 2),
                           static_cast<float>(low.y / 2 + high.y / 2),
                           static_cast<std::uint32_t>(i)});
    }
    items_.reserve(entries.size());
    if (!entries.empty()) build(boxes, entries);
}

// Sorts no boxes but small entries for them, as most of the time goes into moving these about.
void BoxTree::build(std::span<const Box> boxes, std::span<Entry> entries) {
    const std::size_t node = nodes_.size();
    const auto begin = static_cast<std::uint32_t>(items_.size());
    nodes_.push_back({{}, begin, begin + static_cast<std::uint32_t>(entries.size()), 0});
    if (entries.size() <= leaf_size) {
        Box bounds = boxes[entries.front().index];
        for (const Entry& entry : entries) {
            items_.push_back({boxes[entry.index], entry.index});
            bounds = around(bounds, items_.back().box);
        }
        nodes_[node].bounds = bounds;
        return;
    }
    const auto [left, right] = std::ranges::minmax(entries, {}, &Entry::x);
    const auto [bottom, top] = std::ranges::minmax(entries, {}, &Entry::y);
    const auto key = right.x - left.x > top.y - bottom.y ? &Entry::x : &Entry::y;
    const std::size_t middle = entries.size() / 2;
    std::ranges::nth_element(entries, entries.begin() + static_cast<std::ptrdiff_t>(middle), {},
                             key);
    build(boxes, entries.first(middle));
    const std::size_t other = nodes_.size();
    nodes_[node].right = static_cast<std::uint32_t>(other);
    build(boxes, entries.subspan(middle));
    nodes_[node].bounds = around(nodes_[node + 1].bounds, nodes_[other].bounds);
}

}  // namespace asv::core::validation
