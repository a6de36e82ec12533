#include "asv/geometry/free_space.hpp"

#include <cstddef>
#include <limits>

#include "asv/geometry/free_space/cell_graph.hpp"
#include "asv/geometry/free_space/components.hpp"
#include "asv/geometry/free_space/taut_search.hpp"

namespace asv::geometry {

struct FreeSpace::Implementation {
    Implementation(std::span<const Box> boxes, const Box& bounds) : graph(boxes, bounds) {}

    detail::CellGraph graph;
    detail::Components components;
};

FreeSpace::FreeSpace(std::span<const Box> boxes, const Box& bounds)
    : implementation_(std::make_unique<Implementation>(boxes, bounds)) {}
FreeSpace::FreeSpace(FreeSpace&&) noexcept = default;
FreeSpace& FreeSpace::operator=(FreeSpace&&) noexcept = default;
FreeSpace::~FreeSpace() = default;

bool FreeSpace::is_free(const Point& point) {
    return !implementation_->graph.cells_at(point).empty();
}

bool FreeSpace::connected(const Point& from, const Point& to) {
    detail::CellGraph& graph = implementation_->graph;
    const auto targets = graph.cells_at(to);
    for (const detail::CellTree::Id cell : graph.cells_at(from)) {
        for (const detail::CellTree::Id target : targets) {
            if (implementation_->components.connected(graph, cell, target)) return true;
        }
    }
    return false;
}

double FreeSpace::shortest_path(const Point& from, const Point& to) {
    return shortest_path_at_least(from, to, std::numeric_limits<std::size_t>::max());
}

double FreeSpace::shortest_path_at_least(const Point& from, const Point& to, std::size_t effort) {
    if (!connected(from, to)) return std::numeric_limits<double>::infinity();
    return detail::taut_length(implementation_->graph, from, to, effort);
}

std::vector<Point> FreeSpace::shortest_path_points(const Point& from, const Point& to,
                                                   std::size_t effort) {
    if (!connected(from, to)) return {};
    return detail::taut_path(implementation_->graph, from, to, effort);
}

}  // namespace asv::geometry
