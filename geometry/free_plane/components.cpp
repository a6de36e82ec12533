#include "geometry/free_plane/components.hpp"

#include <array>
#include <queue>
#include <unordered_set>
#include <utility>

#include "geometry/elementary/functions.hpp"

namespace asv::geometry::detail {

namespace {

/// Visits cells from one on, those near a target first.
class Flood {
  public:
    Flood(const CellGraph& graph, CellTree::Id from, CellTree::Id target)
        : target_(centre(graph.box(target))) {
        add(graph, from);
    }

    bool exhausted() const { return queue_.empty(); }
    bool has_seen(CellTree::Id cell) const { return seen_.contains(cell); }

    /// Visits one cell; returns it and adds its neighbours.
    CellTree::Id step(CellGraph& graph) {
        const CellTree::Id cell = queue_.top().second;
        queue_.pop();
        for (const Portal& portal : graph.portals(cell)) add(graph, portal.cell);
        return cell;
    }

  private:
    void add(const CellGraph& graph, CellTree::Id cell) {
        if (!seen_.insert(cell).second) return;
        const Point at = centre(graph.box(cell));
        queue_.emplace(-elementary::hypot(at.x - target_.x, at.y - target_.y), cell);
    }

    Point target_;
    std::priority_queue<std::pair<double, CellTree::Id>> queue_;
    std::unordered_set<CellTree::Id> seen_;
};

}  // namespace

void Components::resize(std::size_t cells) {
    for (std::size_t i = parent_.size(); i < cells; ++i) {
        parent_.push_back(static_cast<std::uint32_t>(i));
    }
    complete_.resize(parent_.size());
}

std::uint32_t Components::find(std::uint32_t cell) {
    while (parent_[cell] != cell) {
        parent_[cell] = parent_[parent_[cell]];
        cell = parent_[cell];
    }
    return cell;
}

void Components::unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    parent_[b] = a;
    complete_[a] = complete_[a] | complete_[b];
}

bool Components::connected(CellGraph& graph, CellTree::Id from, CellTree::Id to) {
    resize(graph.cell_limit());
    if (find(from) == find(to)) return true;
    if (complete_[find(from)] || complete_[find(to)]) return false;
    std::array floods{Flood(graph, from, to), Flood(graph, to, from)};
    const std::array origins{from, to};
    for (std::size_t turn = 0;; turn = 1 - turn) {
        Flood& flood = floods[turn];
        if (flood.exhausted()) {
            complete_[find(origins[turn])] = 1;
            return false;
        }
        const CellTree::Id cell = flood.step(graph);
        resize(graph.cell_limit());
        unite(origins[turn], cell);
        if (floods[1 - turn].has_seen(cell)) {
            unite(cell, origins[1 - turn]);
            return true;
        }
    }
}

}  // namespace asv::geometry::detail
