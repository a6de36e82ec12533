#include "geometry/free_plane/cell_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace asv::geometry::detail {

namespace {

/// Up to this many boxes every possible cut is compared; beyond, halving the space matters more.
constexpr std::size_t few_boxes = 8;

double along(const Point& point, std::uint8_t axis) {
    return axis == 0 ? point.x : point.y;
}

bool covers(const Box& outer, const Box& inner) {
    return contains(outer, inner.low) && contains(outer, inner.high);
}

bool interiors_overlap(const Box& a, const Box& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

}  // namespace

/// The points right beside a stretch of an axis-parallel line, on one side of it.
struct CellTree::Strip {
    std::uint8_t axis;  ///< of the line's fixed coordinate
    double at;          ///< the fixed coordinate
    bool above;         ///< which side of the line: towards larger values of the fixed coordinate?
    double from;
    double to;
};

CellTree::CellTree(std::span<const Box> boxes, const Box& bounds)
    : boxes_(boxes.begin(), boxes.end()) {
    std::vector<std::uint32_t> solid;
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
        if (boxes_[i].low.x < boxes_[i].high.x && boxes_[i].low.y < boxes_[i].high.y) {
            solid.push_back(i);
        }
    }
    add_node(bounds, solid);
}

void CellTree::add_node(const Box& box, std::span<const std::uint32_t> candidates) {
    Node& node = nodes_.emplace_back();
    node.box = box;
    for (const std::uint32_t i : candidates) {
        if (!interiors_overlap(boxes_[i], box)) continue;
        if (covers(boxes_[i], box)) {
            node.state = State::blocked;
            node.obstacles = {};
            return;
        }
        node.obstacles.push_back(i);
    }
    if (node.obstacles.empty()) node.state = State::free;
}

bool CellTree::central_side(const Node& node, std::uint8_t axis, double& at) const {
    const double low = along(node.box.low, axis);
    const double high = along(node.box.high, axis);
    const double middle = std::midpoint(low, high);
    double best = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : node.obstacles) {
        for (const double side : {along(boxes_[i].low, axis), along(boxes_[i].high, axis)}) {
            if (low < side && side < high && std::abs(side - middle) < best) {
                best = std::abs(side - middle);
                at = side;
            }
        }
    }
    return std::isfinite(best);
}

CellTree::Cut CellTree::cheapest_cut(const Node& node) const {
    Cut best;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const std::uint8_t axis : {std::uint8_t{0}, std::uint8_t{1}}) {
        const double low = along(node.box.low, axis);
        const double high = along(node.box.high, axis);
        for (const std::uint32_t i : node.obstacles) {
            for (const double side : {along(boxes_[i].low, axis), along(boxes_[i].high, axis)}) {
                if (side <= low || high <= side) continue;
                // Each box that the cut parts makes more cells; the rest decides between equals.
                double cost = std::abs(side - std::midpoint(low, high)) / (high - low);
                for (const std::uint32_t j : node.obstacles) {
                    if (along(boxes_[j].low, axis) < side && side < along(boxes_[j].high, axis)) {
                        cost += 1;
                    }
                }
                if (cost < best_cost) {
                    best_cost = cost;
                    best = {axis, side};
                }
            }
        }
    }
    return best;
}

CellTree::Cut CellTree::choose_cut(const Node& node) const {
    if (node.obstacles.size() <= few_boxes) return cheapest_cut(node);
    const bool wide = node.box.high.x - node.box.low.x >= node.box.high.y - node.box.low.y;
    Cut cut;
    cut.axis = wide ? 0 : 1;
    if (central_side(node, cut.axis, cut.at)) return cut;
    cut.axis = wide ? 1 : 0;
    central_side(node, cut.axis, cut.at);
    return cut;
}

void CellTree::refine(Id id) {
    // A box that covers part of the node, not all, has a side strictly inside it: there is a cut,
    // and both children have fewer sides inside.
    const Cut cut = choose_cut(nodes_[id]);
    const std::vector<std::uint32_t> obstacles = std::move(nodes_[id].obstacles);
    const Id child = static_cast<Id>(nodes_.size());
    Box below = nodes_[id].box;
    Box above = below;
    (cut.axis == 0 ? below.high.x : below.high.y) = cut.at;
    (cut.axis == 0 ? above.low.x : above.low.y) = cut.at;
    nodes_[id].axis = cut.axis;
    nodes_[id].cut = cut.at;
    nodes_[id].child = child;
    nodes_[id].state = State::inner;
    nodes_[id].obstacles = {};
    add_node(below, obstacles);
    add_node(above, obstacles);
}

CellTree::Id CellTree::find(const Point& point, int to_x, int to_y) {
    const Box& bounds = nodes_.front().box;
    const bool inside_x = to_x > 0 ? bounds.low.x <= point.x && point.x < bounds.high.x
                                   : bounds.low.x < point.x && point.x <= bounds.high.x;
    const bool inside_y = to_y > 0 ? bounds.low.y <= point.y && point.y < bounds.high.y
                                   : bounds.low.y < point.y && point.y <= bounds.high.y;
    if (!inside_x || !inside_y) return none;
    Id id = 0;
    while (true) {
        if (nodes_[id].state == State::unrefined) refine(id);
        const Node& node = nodes_[id];
        if (node.state == State::free) return id;
        if (node.state == State::blocked) return none;
        const double at = along(point, node.axis);
        const int to = node.axis == 0 ? to_x : to_y;
        const bool above = node.cut < at || (node.cut == at && to > 0);
        id = node.child + (above ? 1 : 0);
    }
}

void CellTree::collect(Id id, const Strip& strip, std::vector<Id>& found) {
    while (true) {
        if (nodes_[id].state == State::unrefined) refine(id);
        const Node& node = nodes_[id];
        if (node.state == State::blocked) return;
        if (node.state == State::free) {
            found.push_back(id);
            return;
        }
        const Id child = node.child;
        if (node.axis == strip.axis) {
            const bool above = node.cut < strip.at || (node.cut == strip.at && strip.above);
            id = child + (above ? 1 : 0);
        } else if (strip.to <= node.cut) {
            id = child;
        } else if (node.cut <= strip.from) {
            id = child + 1;
        } else {
            collect(child, strip, found);
            id = child + 1;
        }
    }
}

void CellTree::append_neighbours(Id cell, Side side, std::vector<Id>& neighbours) {
    const Box box = nodes_[cell].box;
    const Box& bounds = nodes_.front().box;
    const bool vertical = side == Side::east || side == Side::west;
    Strip strip{};
    strip.axis = vertical ? 0 : 1;
    strip.above = side == Side::east || side == Side::north;
    strip.at = along(strip.above ? box.high : box.low, strip.axis);
    if (strip.at == along(strip.above ? bounds.high : bounds.low, strip.axis)) return;
    strip.from = vertical ? box.low.y : box.low.x;
    strip.to = vertical ? box.high.y : box.high.x;
    collect(0, strip, neighbours);
}

}  // namespace asv::geometry::detail
