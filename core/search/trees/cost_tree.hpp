#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/search/trees/tree.hpp"

namespace asv::core {

/// A tree that knows what the way from the root to each node costs, and can be rewired.
class CostTree {
  public:
    explicit CostTree(const NearestNeighbours& empty_index) : tree_(empty_index) {}

    const Tree& tree() const { return tree_; }
    std::size_t size() const { return tree_.size(); }
    std::span<const double> row(std::uint32_t node) const { return tree_.row(node); }
    /// Of the way from the root.
    double cost(std::uint32_t node) const { return costs_[node]; }
    /// Of the motion from the parent; 0 for the root.
    double edge_cost(std::uint32_t node) const { return edge_costs_[node]; }

    std::uint32_t add(std::span<const double> row, std::uint32_t parent, double edge_cost) {
        const std::uint32_t node = tree_.add(row, parent);
        children_.emplace_back();
        edge_costs_.push_back(edge_cost);
        costs_.push_back(parent == Tree::none ? 0 : costs_[parent] + edge_cost);
        if (parent != Tree::none) children_[parent].push_back(node);
        return node;
    }

    /// Hangs the node under another parent and passes the new cost on to all its descendants.
    /// Precondition: that makes it cheaper, so that the parent is no descendant of it.
    void rewire(std::uint32_t node, std::uint32_t parent, double edge_cost) {
        std::erase(children_[tree_.parent(node)], node);
        children_[parent].push_back(node);
        tree_.set_parent(node, parent);
        edge_costs_[node] = edge_cost;
        std::vector<std::uint32_t> stale{node};
        while (!stale.empty()) {
            const std::uint32_t next = stale.back();
            stale.pop_back();
            costs_[next] = costs_[tree_.parent(next)] + edge_costs_[next];
            stale.insert(stale.end(), children_[next].begin(), children_[next].end());
        }
    }

    Tree release() { return std::move(tree_); }

  private:
    Tree tree_;
    std::vector<double> costs_, edge_costs_;
    std::vector<std::vector<std::uint32_t>> children_;
};

}  // namespace asv::core
