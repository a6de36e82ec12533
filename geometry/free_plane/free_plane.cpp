#include "geometry/free_plane/free_plane.hpp"

#include <cstddef>
#include <limits>

#include "geometry/free_plane/cell_graph.hpp"
#include "geometry/free_plane/components.hpp"
#include "geometry/free_plane/taut_search.hpp"

namespace asv::geometry {

struct FreePlane::Implementation {
    Implementation(std::span<const Box> boxes, const Box& bounds) : graph(boxes, bounds) {}

    detail::CellGraph graph;
    detail::Components components;
};

FreePlane::FreePlane(std::span<const Box> boxes, const Box& bounds)
    : implementation_(std::make_unique<Implementation>(boxes, bounds)) {}
FreePlane::FreePlane(FreePlane&&) noexcept = default;
FreePlane& FreePlane::operator=(FreePlane&&) noexcept = default;
FreePlane::~FreePlane() = default;

bool FreePlane::is_free(const Point& point) {
    return !implementation_->graph.cells_at(point).empty();
}

bool FreePlane::connected(const Point& from, const Point& to) {
    detail::CellGraph& graph = implementation_->graph;
    const auto targets = graph.cells_at(to);
    for (const detail::CellTree::Id cell : graph.cells_at(from)) {
        for (const detail::CellTree::Id target : targets) {
            if (implementation_->components.connected(graph, cell, target)) return true;
        }
    }
    return false;
}

double FreePlane::shortest_path(const Point& from, const Point& to) {
    return shortest_path_at_least(from, to, std::numeric_limits<std::size_t>::max());
}

double FreePlane::shortest_path_at_least(const Point& from, const Point& to, std::size_t effort) {
    if (!connected(from, to)) return std::numeric_limits<double>::infinity();
    return detail::taut_length(implementation_->graph, from, to, effort);
}

std::vector<Point> FreePlane::shortest_path_points(const Point& from, const Point& to,
                                                   std::size_t effort) {
    if (!connected(from, to)) return {};
    return detail::taut_path(implementation_->graph, from, to, effort);
}

}  // namespace asv::geometry
