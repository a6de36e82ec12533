#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/search/rng.hpp"
#include "core/search/trees/tree.hpp"
#include "geometry/elementary/functions.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// Which part of a tree has come how far along a way through the plane, so that it can be grown
/// where it has come farthest: a region that moves along the way ahead of the tree (dynamic
/// region-biased RRT: Denny, Sandström, Bregger and Amato, 2016). The way is a row of stops.
class RegionBias {
  public:
    explicit RegionBias(std::vector<geometry::Point> stops)
        : stops_(std::move(stops)), nodes_at_(stops_.size()) {}

    /// Takes note of the nodes that the tree has got since the last call; position(row) is where
    /// the point of the body is that goes the way. A node's stop is the nearest one that is not far
    /// from its parent's, so that it cannot jump through a wall.
    template <class Position>
    void follow(const Tree& tree, Position&& position) {
        for (auto node = static_cast<std::uint32_t>(stop_of_.size()); node < tree.size(); ++node) {
            const geometry::Point at = position(tree.row(node));
            const std::uint32_t parent = tree.parent(node);
            const std::size_t near = parent == Tree::none ? 0 : stop_of_[parent];
            std::size_t best = near;
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t stop = near - std::min(near, window);
                 stop <= std::min(near + window, stops_.size() - 1); ++stop) {
                const double distance =
                    elementary::hypot(at.x - stops_[stop].x, at.y - stops_[stop].y);
                if (distance >= least) continue;
                least = distance;
                best = stop;
            }
            stop_of_.push_back(best);
            nodes_at_[best].push_back(node);
            if (best <= frontier_) continue;
            frontier_ = best;
            in_vain_ = 0;
        }
    }

    /// How often region() was asked since the frontier moved.
    std::size_t in_vain() const { return in_vain_; }

    /// A stop at the frontier or a little behind it, where there are nodes.
    std::size_t region(Rng& rng) {
        ++in_vain_;
        std::size_t stop = frontier_;
        while (stop > 0 && (nodes_at_[stop].empty() || rng.chance(0.5))) --stop;
        return nodes_at_[stop].empty() ? frontier_ : stop;
    }

    /// A node at the stop. Precondition: it is of region().
    std::uint32_t node_at(std::size_t stop, Rng& rng) const {
        return nodes_at_[stop][rng.below(nodes_at_[stop].size())];
    }

    /// A stop ahead of that one.
    const geometry::Point& ahead(std::size_t stop, Rng& rng) const {
        return stops_[std::min(stop + 1 + rng.below(2), stops_.size() - 1)];
    }

  private:
    static constexpr std::size_t window = 2;

    std::vector<geometry::Point> stops_;
    std::vector<std::size_t> stop_of_;                  ///< of each node
    std::vector<std::vector<std::uint32_t>> nodes_at_;  ///< of each stop
    std::size_t frontier_ = 0;                          ///< the last stop that has nodes
    std::size_t in_vain_ = 0;
};

}  // namespace asv::core
