#pragma once

#include <algorithm>
#include <numbers>
#include <span>
#include <vector>

#include "core/search/limits.hpp"
#include "core/search/setting.hpp"
#include "core/search/trees/cost_tree.hpp"
#include "core/search/trees/one_tree.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

/// What each field is, settings_of() says below.
struct RrtStarOptions {
    double step = 0.1;
    double goal_bias = 0.1;
    double radius = 0;
    double gamma = 0;
    std::size_t nodes = 5000;
};

inline std::vector<Setting> settings_of(RrtStarOptions& options) {
    return {
        {.name = "step",
         .meaning = "longest motion of an extension; 0: a tenth of the longest side",
         .value = number(options.step, 0, 1e4, in_metric),
         .why = "a tenth of the side, a round number, suits every body; rrt_star() itself, which "
                "knows no sides, has 0.1",
         .source = "Karaman and Frazzoli 2011"},
        {.name = "goal-bias",
         .meaning = "share of the samples that are the goal until it is reached",
         .value = number(options.goal_bias, 0, 1),
         .why = "10 %, as reported for a point on a map",
         .source = "LaValle 1998"},
        {.name = "radius",
         .meaning = "of the neighbours; 0: gamma (log n / n)^(1/dimension), at most a step",
         .value = number(options.radius, 0, 1e4, in_metric),
         .why = "the shrinking radius of the theory; a fixed one of two steps is reported for a "
                "point on a map",
         .source = "Karaman and Frazzoli 2011"},
        {.name = "gamma",
         .meaning = "of that formula; 0: the least one of the theory",
         .value = number(options.gamma, 0, 1e4, in_metric),
         .why = "the least one with which paths converge to the shortest has the fewest neighbours "
                "to look at",
         .source = "Karaman and Frazzoli 2011, theorem 38"},
        {.name = "nodes",
         .meaning = "nodes after which it stops to improve its path",
         .value = number(options.nodes, 2, 1e7),
         .why = "a round number: some 0.2 s for three ASVs; without a path it goes on until its "
                "limits",
         .source = "own"},
    };
}

/// The logarithm of the volume of the unit ball, by V(d) = 2 pi / d V(d - 2). Not by std::lgamma:
/// it writes to a global variable, a data race between threads.
inline double log_unit_ball(std::size_t dimension) {
    double log_volume = dimension % 2 == 0 ? 0 : elementary::log(2);
    for (std::size_t d = dimension; d >= 2; d -= 2)
        log_volume += elementary::log(2 * std::numbers::pi / static_cast<double>(d));
    return log_volume;
}

/// The least gamma with which RRT* converges to the optimum in a free space as large as the bounds
/// (Karaman and Frazzoli, 2011, theorem 38): 2 (1 + 1/d)^(1/d) (volume / volume of the unit
/// ball)^(1/d), lengths in the metric.
template <SampledSpace Space>
double min_gamma(Space& space) {
    const auto d = static_cast<double>(space.dimension());
    double log_volume = 0;
    for (std::size_t i = 0; i < space.dimension(); ++i)
        log_volume += elementary::log(space.extent(i));
    return 2 * elementary::pow(1 + 1 / d, 1 / d) *
           elementary::exp((log_volume - log_unit_ball(space.dimension())) / d);
}

/// One search of rrt_star(): the tree, and the steps of the algorithm by their names.
template <SampledSpace Space>
class StarTree {
  public:
    StarTree(Space& space, const Query& query, const RrtStarOptions& options)
        : space_(space),
          options_(options),
          gamma_(options.gamma > 0 ? options.gamma : min_gamma(space)),
          tree_(space.make_index()),
          other_(space.dimension()) {
        tree_.add(query.start, Tree::none, 0);
    }

    const CostTree& tree() const { return tree_; }
    CostTree& tree() { return tree_; }

    /// Fixed, or gamma (log n / n)^(1/d); at most a step, as one cannot be longer.
    double radius() const {
        if (options_.radius > 0) return options_.radius;
        const auto n = static_cast<double>(tree_.size() + 1);
        const double shrinking =
            gamma_ *
            elementary::pow(elementary::log(n) / n, 1 / static_cast<double>(space_.dimension()));
        return std::min(shrinking, options_.step);
    }

    /// Adds the row under the neighbour through which it costs least, then hangs those neighbours
    /// under it that it makes cheaper. Precondition: the motion from the nearest node is valid.
    std::uint32_t insert(std::span<const double> row, std::uint32_t nearest) {
        find_neighbours(row, nearest);
        const Neighbour parent = choose_parent(row, nearest);
        const std::uint32_t node = tree_.add(row, parent.node, parent.edge_cost);
        for (const Neighbour& neighbour : neighbours_) {
            if (tree_.cost(node) + neighbour.edge_cost >= tree_.cost(neighbour.node)) continue;
            if (valid(row, neighbour.node)) tree_.rewire(neighbour.node, node, neighbour.edge_cost);
        }
        return node;
    }

  private:
    struct Neighbour {
        std::uint32_t node;
        double edge_cost;
        double cost;  ///< of the way through it
    };

    void find_neighbours(std::span<const double> row, std::uint32_t nearest) {
        auto found = tree_.tree().neighbours().within(row, radius());
        if (std::find(found.begin(), found.end(), nearest) == found.end()) found.push_back(nearest);
        neighbours_.clear();
        for (const std::size_t index : found) {
            const auto node = static_cast<std::uint32_t>(index);
            unwrap_to(row, node);
            const double edge = space_.cost(row, other_);
            neighbours_.push_back({node, edge, tree_.cost(node) + edge});
        }
    }

    Neighbour choose_parent(std::span<const double> row, std::uint32_t nearest) {
        std::stable_sort(neighbours_.begin(), neighbours_.end(),
                         [](const Neighbour& a, const Neighbour& b) { return a.cost < b.cost; });
        std::size_t i = 0;
        while (neighbours_[i].node != nearest && !valid(row, neighbours_[i].node)) ++i;
        return neighbours_[i];
    }

    bool valid(std::span<const double> row, std::uint32_t node) {
        unwrap_to(row, node);
        return space_.motion_valid(row, other_);
    }

    /// The node's row, unwrapped to the given one, into other_.
    void unwrap_to(std::span<const double> row, std::uint32_t node) {
        const auto other = tree_.row(node);
        std::copy(other.begin(), other.end(), other_.begin());
        unwrap(other_, row, space_.wrapping());
    }

    Space& space_;
    RrtStarOptions options_;
    double gamma_;
    CostTree tree_;
    std::vector<Neighbour> neighbours_;
    std::vector<double> other_;
};

/// RRT* (Karaman and Frazzoli, 2011): a tree as that of rrt() in which every new node hangs under
/// the neighbour through which it costs least, and neighbours are rewired through it where that is
/// cheaper. The goal is a node like others once it has been reached, so its cost falls until the
/// budget is spent. Ends earlier when no path can cost less.
template <SampledSpace Space>
SearchResult rrt_star(Space& space, const Query& query, const RrtStarOptions& options,
                      const Limits& limits, Rng& rng, const Observer& observer = {}) {
    StarTree<Space> star(space, query, options);
    const CostTree& tree = star.tree();
    SearchResult result;
    std::vector<double> row(query.goal.begin(), query.goal.end());
    std::uint32_t goal = Tree::none;
    const auto reach_for_goal = [&](std::uint32_t node) {
        std::copy(query.goal.begin(), query.goal.end(), row.begin());
        unwrap(row, tree.row(node), space.wrapping());
        const bool near = node == 0 || space.distance(tree.row(node), row) <= options.step;
        if (near && space.motion_valid(tree.row(node), row)) goal = star.insert(row, node);
    };
    const double cheapest = space.cost_lower_bound(query.start, query.goal) * (1 + 1e-9);

    reach_for_goal(0);
    while (true) {
        Progress progress{result.iterations, {tree.size(), 0}};
        if (goal != Tree::none) progress.cost = tree.cost(goal);
        if (must_end(progress, limits, observer, result) || progress.cost <= cheapest) break;
        if (goal != Tree::none && tree.size() >= options.nodes) break;
        ++result.iterations;
        if (goal == Tree::none && rng.chance(options.goal_bias))
            std::copy(query.goal.begin(), query.goal.end(), row.begin());
        else if (!space.sample(rng, row))
            continue;
        const std::uint32_t nearest = step_toward(space, tree.tree(), options.step, row);
        if (!space.motion_valid(tree.row(nearest), row)) continue;
        const std::uint32_t node = star.insert(row, nearest);
        if (goal == Tree::none) reach_for_goal(node);
    }
    if (goal != Tree::none) {
        result.outcome = Outcome::solved;
        result.path = path_to(tree.tree(), goal, space.wrapping());
    }
    result.trees.push_back(star.tree().release());
    return result;
}

}  // namespace asv::core
