#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/search/trees/nearest.hpp"

namespace asv::core {

/// A search tree: configurations as rows of one block, parents as indices, and the index of nearest
/// neighbours over them. Node 0 is the root.
class Tree {
  public:
    static constexpr std::uint32_t none = 0xffffffff;

    explicit Tree(const NearestNeighbours& empty_index)
        : dimension_(empty_index.dimension()), nearest_(empty_index) {}

    std::size_t size() const { return parents_.size(); }
    std::span<const double> row(std::uint32_t node) const {
        return {rows_.data() + node * dimension_, dimension_};
    }
    std::uint32_t parent(std::uint32_t node) const { return parents_[node]; }

    /// Returns the new node's index. Precondition: parent is a node, or none for the root.
    std::uint32_t add(std::span<const double> row, std::uint32_t parent) {
        rows_.insert(rows_.end(), row.begin(), row.end());
        parents_.push_back(parent);
        nearest_.add(row);
        return static_cast<std::uint32_t>(parents_.size() - 1);
    }

    /// The node nearest to the row. Precondition: not empty.
    std::uint32_t nearest(std::span<const double> row) const {
        return static_cast<std::uint32_t>(nearest_.nearest(row));
    }

    /// Hangs the node under another parent. Precondition: the parent is no descendant of it.
    void set_parent(std::uint32_t node, std::uint32_t parent) { parents_[node] = parent; }

    /// The nodes' rows, for other queries than that for the nearest one.
    const NearestNeighbours& neighbours() const { return nearest_; }

    /// The nodes from the given one to the root.
    std::vector<std::uint32_t> to_root(std::uint32_t node) const {
        std::vector<std::uint32_t> nodes;
        for (; node != none; node = parents_[node]) nodes.push_back(node);
        return nodes;
    }

  private:
    std::size_t dimension_;
    std::vector<double> rows_;
    std::vector<std::uint32_t> parents_;
    NearestNeighbours nearest_;
};

}  // namespace asv::core
