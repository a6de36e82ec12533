#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/search/trees/interpolate.hpp"
#include "core/search/trees/tree.hpp"

namespace asv::core {

/// The trees of a bidirectional search and the operations that all of them share.
template <ConfigurationSpace Space>
class TwoTrees {
  public:
    TwoTrees(Space& space, const Query& query)
        : space_(space), trees_(2, Tree(space.make_index())), target_(space.dimension()) {
        trees_[0].add(query.start, Tree::none);
        trees_[1].add(query.goal, Tree::none);
    }

    const Tree& operator[](int side) const { return trees_[static_cast<std::size_t>(side)]; }
    Progress progress(std::size_t iterations) const {
        return {iterations, {trees_[0].size(), trees_[1].size()}};
    }

    struct Growth {
        Steered outcome;
        std::uint32_t last;  ///< the newest node, or where the growth was trapped
    };

    /// Extends the tree from its node nearest to the target as far toward it as steering comes.
    Growth grow(int side, std::span<const double> target) {
        return grow(side, (*this)[side].nearest(target), target);
    }

    /// The same from a given node.
    Growth grow(int side, std::uint32_t node, std::span<const double> target) {
        const auto from = (*this)[side].row(node);
        std::copy(target.begin(), target.end(), target_.begin());
        unwrap(target_, from, space_.wrapping());
        visited_.clear();
        const Steered outcome = space_.steer(from, target_, visited_);
        return {outcome, add(side, node, visited_)};
    }

    /// Adds rows one behind the other; returns the last node.
    std::uint32_t add(int side, std::uint32_t parent, const Configurations& rows) {
        const std::size_t d = space_.dimension();
        for (std::size_t i = 0; i < rows.size(); i += d)
            parent = trees_[static_cast<std::size_t>(side)].add({rows.data() + i, d}, parent);
        return parent;
    }

    /// The path from start to goal through two nodes, one of each tree, of one configuration.
    Configurations join(std::uint32_t in_start_tree, std::uint32_t in_goal_tree) const {
        Configurations path;
        auto forward = trees_[0].to_root(in_start_tree);
        std::reverse(forward.begin(), forward.end());
        for (const auto node : forward) {
            const auto row = trees_[0].row(node);
            path.insert(path.end(), row.begin(), row.end());
        }
        // The angles of the goal tree, turned by as many full turns as they differ by where it
        // meets the start tree.
        const WrappingAngles angles = space_.wrapping();
        const auto meeting = trees_[1].row(in_goal_tree);
        std::vector<double> turns(space_.dimension(), 0.0);
        for (std::size_t i = angles.first; i < angles.first + angles.count; ++i)
            turns[i] = path[path.size() - turns.size() + i] - meeting[i];
        for (auto node = trees_[1].parent(in_goal_tree); node != Tree::none;
             node = trees_[1].parent(node)) {
            const auto row = trees_[1].row(node);
            path.insert(path.end(), row.begin(), row.end());
            for (std::size_t i = 0; i < turns.size(); ++i)
                path[path.size() - turns.size() + i] += turns[i];
        }
        return path;
    }

    std::vector<Tree> release() { return std::move(trees_); }

  private:
    Space& space_;
    std::vector<Tree> trees_;
    std::vector<double> target_;
    Configurations visited_;
};

}  // namespace asv::core
