#include "core/generate/vouch/round_map.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/elementary/functions.hpp"
#include "geometry/predicates/distance.hpp"

namespace asv::core {

namespace {

// A disc that passes a corner between two nodes comes nearer to it by at most spacing^2 / (8
// radius), 0.00125 of the radius: with this to spare it still does not touch.
constexpr double spare = 0.002;

}  // namespace

RoundMap::RoundMap(const Problem& problem, double radius)
    : spacing_(std::max(radius / 10, 1.0 / 2000)),
      side_(static_cast<std::uint32_t>(std::ceil(1 / spacing_)) + 1) {
    const std::size_t count = std::size_t{side_} * side_;
    free_.assign(count, true);
    const double kept = radius * (1 + spare);
    const Box inside = geometry::grown(problem.requirements.bounds, -kept);
    for (std::uint32_t node = 0; node < count; ++node) {
        const Point p = place(node);
        free_[node] = p.x >= inside.low.x && p.x <= inside.high.x && p.y >= inside.low.y &&
                      p.y <= inside.high.y;
    }
    for (const Box& box : problem.obstacles) block(box, kept);
    label_components();
}

Point RoundMap::place(std::uint32_t node) const {
    return {spacing_ * (node % side_), spacing_ * (node / side_)};
}

void RoundMap::block(const Box& box, double radius) {
    const auto index = [&](double value) {
        return static_cast<std::uint32_t>(
            std::clamp(value / spacing_, 0.0, static_cast<double>(side_ - 1)));
    };
    const Box near = geometry::grown(box, radius);
    for (std::uint32_t row = index(near.low.y); row <= index(near.high.y); ++row) {
        for (std::uint32_t column = index(near.low.x); column <= index(near.high.x); ++column) {
            const std::uint32_t node = row * side_ + column;
            if (free_[node] && geometry::distance(place(node), box) <= radius) free_[node] = false;
        }
    }
}

template <class Visit>
void RoundMap::visit_neighbours(std::uint32_t node, Visit&& visit) const {
    const std::uint32_t column = node % side_;
    const std::uint32_t row = node / side_;
    if (column > 0 && free_[node - 1]) visit(node - 1);
    if (column + 1 < side_ && free_[node + 1]) visit(node + 1);
    if (row > 0 && free_[node - side_]) visit(node - side_);
    if (row + 1 < side_ && free_[node + side_]) visit(node + side_);
}

void RoundMap::label_components() {
    component_.assign(free_.size(), none);
    std::uint32_t label = 0;
    std::vector<std::uint32_t> stack;
    for (std::uint32_t seed = 0; seed < free_.size(); ++seed) {
        if (!free_[seed] || component_[seed] != none) continue;
        component_[seed] = label;
        stack.push_back(seed);
        while (!stack.empty()) {
            const std::uint32_t node = stack.back();
            stack.pop_back();
            visit_neighbours(node, [&](std::uint32_t next) {
                if (component_[next] != none) return;
                component_[next] = label;
                stack.push_back(next);
            });
        }
        ++label;
    }
}

std::vector<std::uint32_t> RoundMap::near(const Point& point, double distance,
                                          std::size_t count) const {
    const auto distance_to = [&](std::uint32_t node) {
        const Point p = place(node);
        return elementary::hypot(p.x - point.x, p.y - point.y);
    };
    std::vector<std::uint32_t> found;
    for (std::uint32_t node = 0; node < free_.size(); ++node) {
        if (free_[node] && distance_to(node) <= distance) found.push_back(node);
    }
    std::stable_sort(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
        return distance_to(a) < distance_to(b);
    });
    if (found.size() <= count) return found;
    std::vector<std::uint32_t> thinned;
    for (std::size_t i = 0; i < count; ++i) thinned.push_back(found[i * found.size() / count]);
    return thinned;
}

std::vector<Point> RoundMap::route(std::uint32_t from, std::uint32_t to) const {
    // Searched from the far end, so that following the parents leads the right way.
    std::vector<std::uint32_t> parent(free_.size(), none);
    std::vector<std::uint32_t> queue{to};
    parent[to] = to;
    for (std::size_t i = 0; i < queue.size() && parent[from] == none; ++i) {
        visit_neighbours(queue[i], [&](std::uint32_t next) {
            if (parent[next] != none) return;
            parent[next] = queue[i];
            queue.push_back(next);
        });
    }
    std::vector<Point> corners{place(from)};
    for (std::uint32_t node = from; node != to;) {
        const std::uint32_t next = parent[node];
        const bool straight = next != to && parent[next] - next == next - node;
        if (!straight) corners.push_back(place(next));
        node = next;
    }
    return corners;
}

}  // namespace asv::core
