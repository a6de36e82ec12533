#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/search/trees/tree.hpp"

namespace asv::core {

/// A graph of configurations, joined where the straight motion between them is valid.
class Roadmap {
  public:
    struct Edge {
        std::uint32_t from, to;
        double cost;
    };

    explicit Roadmap(const NearestNeighbours& empty_index) : nodes_(empty_index) {}

    std::size_t size() const { return nodes_.size(); }
    std::span<const double> row(std::uint32_t node) const { return nodes_.row(node); }
    const NearestNeighbours& neighbours() const { return nodes_.neighbours(); }
    std::span<const Edge> edges() const { return edges_; }
    /// The nodes as a forest of roots.
    const Tree& nodes() const { return nodes_; }

    std::uint32_t add(std::span<const double> row);
    /// Precondition: both are nodes, cost >= 0.
    void join(std::uint32_t from, std::uint32_t to, double cost);

    /// Is there a path between the two nodes? Nearly constant time (Tarjan, 1975).
    bool connected(std::uint32_t from, std::uint32_t to) const;

    /// The nodes of a path of least cost, both ends included; empty when there is none.
    /// Dijkstra (1959), by Boost.Graph.
    std::vector<std::uint32_t> dijkstra(std::uint32_t from, std::uint32_t to) const;

    /// The same by A* (Hart, Nilsson and Raphael, 1968), which looks at fewer nodes.
    /// cost_lower_bound(node): no path from there to the end costs less. Precondition: it obeys the
    /// triangle inequality.
    std::vector<std::uint32_t> a_star(
        std::uint32_t from, std::uint32_t to,
        const std::function<double(std::uint32_t)>& cost_lower_bound) const;

  private:
    std::uint32_t component(std::uint32_t node) const;

    Tree nodes_;
    std::vector<Edge> edges_;
    mutable std::vector<std::uint32_t> leaders_;  ///< disjoint sets of connected nodes
};

}  // namespace asv::core
