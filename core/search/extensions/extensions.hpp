#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/search/extensions/collision_swap.hpp"
#include "core/search/extensions/control_chosen.hpp"
#include "core/search/extensions/exhaustion.hpp"
#include "core/search/extensions/extension_options.hpp"
#include "core/search/extensions/goal_bias.hpp"
#include "core/search/extensions/neighbour_cost.hpp"
#include "core/search/extensions/passage_filter.hpp"
#include "core/search/extensions/swap_limiter.hpp"
#include "core/search/trees/two_trees.hpp"

/// The seven extensions of RRT-Connect, each alone or in any combination.

namespace asv::core {

/// None of them: the base, at no cost.
struct NoExtensions {
    template <class Space>
    bool draw(Space& space, const TwoTrees<Space>&, int, Rng& rng, std::span<double> out) {
        return space.sample(rng, out);
    }
    std::uint32_t nearest(const Tree& tree, int, std::span<const double> row) {
        return tree.nearest(row);
    }
    template <class Space>
    void grown(Space&, const Tree&, int, std::uint32_t, Steered, std::uint32_t) {}
    bool swaps() { return true; }
};

/// Those that are on, each at its seam of the search: draw, nearest, grown, swaps.
class Extensions {
  public:
    Extensions(const Query& query, const ExtensionOptions& options)
        : query_(query),
          swap_limiter_(options.swap_limiter ? options.swap_steps : 0, options.swap_step),
          collision_swap_(options.collision_swap),
          exhaustion_(options.exhaustion),
          neighbour_cost_(query, options.neighbour_cost ? options.quality_floor : 1),
          passage_(options.passage ? options.passage_filter : PassageFilter{0, 0}),
          control_{options.control_chosen ? options.control_reach
                                          : std::numeric_limits<double>::infinity()},
          goal_bias_{options.goal_bias ? options.goal_probability : 0} {}

    /// A sample for a tree to grow to; false when a draw failed or was not kept, which is a try of
    /// its own, so that resampling ends with the limits of the search.
    template <class Space>
    bool draw(Space& space, const TwoTrees<Space>& trees, int side, Rng& rng,
              std::span<double> out) {
        if (goal_bias_.chosen(rng)) {
            const auto root = trees[1 - side].row(0);
            std::copy(root.begin(), root.end(), out.begin());
            return true;
        }
        return space.sample(rng, out) && control_.accept(space, query_, out) &&
               passage_.accept(space, out, rng) &&
               neighbour_cost_.accept(space, trees[side], side, out, rng);
    }

    /// The node of a tree to grow from.
    std::uint32_t nearest(const Tree& tree, int side, std::span<const double> row) {
        return exhaustion_.nearest(tree, side, row);
    }

    /// Tells of a growth of a tree from a node to its newest one.
    template <class Space>
    void grown(Space& space, const Tree& tree, int side, std::uint32_t from, Steered outcome,
               std::uint32_t last) {
        exhaustion_.grown(side, from, outcome);
        collision_swap_.grown(outcome);
        if constexpr (requires { space.steps_tried(); })
            swap_limiter_.stepped(space.steps_tried());
        else
            swap_limiter_.grown(space.distance(tree.row(from), tree.row(last)));
    }

    /// Do the trees change roles after this iteration? Both rules have to agree.
    bool swaps() {
        const bool collided = collision_swap_.due();
        return collided && swap_limiter_.due();
    }

  private:
    Query query_;
    SwapLimiter swap_limiter_;
    CollisionSwap collision_swap_;
    Exhaustion exhaustion_;
    NeighbourCost neighbour_cost_;
    PassageFilter passage_;
    ControlChosen control_;
    GoalBias goal_bias_;
};

}  // namespace asv::core
