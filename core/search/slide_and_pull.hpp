#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/search/limits.hpp"
#include "core/search/region_bias.hpp"
#include "core/search/setting.hpp"
#include "core/search/trees/two_trees.hpp"
#include "geometry/elementary/functions.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// Which end of the chain goes first all the way: it leads out of the start, so that the other end
/// is the last to come into the goal.
enum class Leader { either, first_asv, last_asv };

/// Options of the search by slides and pulls. What each setting is, settings_of() says below.
struct SlideAndPullOptions {
    double pull_share = 0.5;
    double guide_share = 0.8;
    double guide_patience = 5;
    double passage_share = 0.5;
    std::size_t pull_candidates = 24;
    Leader leader = Leader::either;  ///< the end that is pulled
};

inline std::vector<Setting> settings_of(SlideAndPullOptions& options) {
    return {
        {.name = "pull-share",
         .meaning = "share of the iterations that pull",
         .value = number(options.pull_share, 0, 1),
         .why = "a round number; with 0, 7ASV-x2 takes seconds instead of milliseconds",
         .source = "own"},
        {.name = "guide-share",
         .meaning = "share of the iterations that grow a tree along the shortest way of one ASV",
         .value = number(options.guide_share, 0, 1),
         .why = "mazes are solved ten times faster than with 0; the rest keeps looking elsewhere",
         .source = "Denny and others 2016"},
        {.name = "guide-patience",
         .meaning = "such iterations in vain after which that share has halved",
         .value = number(options.guide_patience, 0.01, 1e9),
         .why = "few, since a chain that has to turn before it can go on must not wait for it; a "
                "round number",
         .source = "own"},
        {.name = "passage-share",
         .meaning = "share of the pulls whose target lies in a passage (bridge test)",
         .value = number(options.passage_share, 0, 1),
         .why = "a round number: passages are what a chain has to be pulled into, the other half "
                "goes everywhere",
         .source = "Hsu and others 2003"},
        {.name = "pull-candidates",
         .meaning = "nodes of which the most promising one is pulled",
         .value = number(options.pull_candidates, 1, 1e4),
         .why = "two dozen, a round number",
         .source = "own"},
    };
}

/// A space whose body can be dragged by one of its points.
template <class Space>
concept PullableSpace = ConfigurationSpace<Space> &&
    requires(Space& space, Rng& rng, std::span<const double> row, std::size_t asv,
             const geometry::Point& point, std::span<double> out, Configurations& visited) {
    { space.asv_count() } -> std::convertible_to<std::size_t>;
    { space.pull_target(rng, 0.5) } -> std::same_as<std::optional<geometry::Point>>;
    { space.position(row, asv) } -> std::same_as<geometry::Point>;
    { space.guide() } -> std::same_as<std::vector<geometry::Point>>;
    { space.sample_near(rng, point, out) } -> std::same_as<bool>;
    { space.pull(row, asv, point, visited) } -> std::same_as<Steered>;
};

/// Iterations before the shortest way is looked for: easy problems are solved by then.
inline constexpr std::size_t unguided_iterations = 20;

/// One search of slide_and_pull(): the trees, and the steps of the algorithm by their names.
template <PullableSpace Space>
class SlideAndPull {
  public:
    SlideAndPull(Space& space, const Query& query, const SlideAndPullOptions& options, Rng& rng)
        : space_(space),
          options_(options),
          rng_(rng),
          trees_(space, query),
          target_(query.goal.begin(), query.goal.end()) {}

    SearchResult search(const Limits& limits, const Observer& observer) {
        SearchResult result;
        bool met = connect(goal_tree, root);
        while (!met) {
            if (must_end(trees_.progress(result.iterations), limits, observer, result)) break;
            ++result.iterations;
            if (result.iterations == unguided_iterations) look_for_guide();
            const int side = smaller_tree();
            const std::optional<std::uint32_t> node = grow(side);
            met = node && connect(side, *node);
        }
        if (met) result.outcome = Outcome::solved;
        result.path = std::move(path_);
        result.trees = trees_.release();
        return result;
    }

  private:
    /// The newest node, where a tree has grown at all.
    using Grown = std::optional<std::uint32_t>;
    static constexpr int start_tree = 0, goal_tree = 1;
    static constexpr std::uint32_t root = 0;

    int smaller_tree() const {
        return trees_[start_tree].size() <= trees_[goal_tree].size() ? start_tree : goal_tree;
    }

    Grown grow(int side) {
        if (rng_.chance(guided_share(side))) return advance(side);
        return rng_.chance(options_.pull_share) ? pull(side) : extend(side);
    }

    /// Steers toward a sample.
    Grown extend(int side) {
        if (!space_.sample(rng_, target_)) return std::nullopt;
        return steer_to_target(side);
    }

    /// Drags an end of a node that is near a point of the plane to that point.
    Grown pull(int side) {
        const auto point = space_.pull_target(rng_, options_.passage_share);
        if (!point) return std::nullopt;
        const std::size_t end = leading_end(side);
        return drag(side, nearest_of_some(side, end, *point), end, *point);
    }

    /// Grows the tree where it has come farthest on the shortest way through the plane.
    Grown advance(int side) {
        RegionBias& bias = guide_[static_cast<std::size_t>(side)];
        bias.follow(trees_[side],
                    [&](auto row) { return space_.position(row, space_.asv_count() / 2); });
        const std::size_t region = bias.region(rng_);
        const geometry::Point& ahead = bias.ahead(region, rng_);
        if (rng_.chance(options_.pull_share)) {
            const std::uint32_t node = bias.node_at(region, rng_);
            return drag(side, node, leading_end(side), ahead);
        }
        if (!space_.sample_near(rng_, ahead, target_)) return std::nullopt;
        return steer_to_target(side);
    }

    /// Lets the other tree reach for a node. True when they meet.
    bool connect(int side, std::uint32_t node) {
        const auto row = trees_[side].row(node);
        target_.assign(row.begin(), row.end());
        const auto growth = trees_.grow(1 - side, target_);
        if (growth.outcome != Steered::reached) return false;
        path_ =
            side == start_tree ? trees_.join(node, growth.last) : trees_.join(growth.last, node);
        return true;
    }

    Grown steer_to_target(int side) {
        const auto growth = trees_.grow(side, target_);
        if (growth.outcome == Steered::trapped) return std::nullopt;
        return growth.last;
    }

    Grown drag(int side, std::uint32_t node, std::size_t end, const geometry::Point& point) {
        visited_.clear();
        if (space_.pull(trees_[side].row(node), end, point, visited_) == Steered::trapped)
            return std::nullopt;
        return trees_.add(side, node, visited_);
    }

    /// The end to be pulled; the tree of the goal, which grows backward, is led by the other one.
    std::size_t leading_end(int side) {
        const bool first = options_.leader == Leader::either
                               ? rng_.chance(0.5)
                               : (options_.leader == Leader::first_asv) == (side == start_tree);
        return first ? 0 : space_.asv_count() - 1;
    }

    /// Of some random nodes, the one whose end of the chain is nearest to the point.
    std::uint32_t nearest_of_some(int side, std::size_t end, const geometry::Point& point) {
        const Tree& tree = trees_[side];
        std::uint32_t nearest = root;
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < options_.pull_candidates; ++i) {
            const auto node = static_cast<std::uint32_t>(rng_.below(tree.size()));
            const geometry::Point at = space_.position(tree.row(node), end);
            const double distance = elementary::hypot(at.x - point.x, at.y - point.y);
            if (distance >= shortest) continue;
            shortest = distance;
            nearest = node;
        }
        return nearest;
    }

    void look_for_guide() {
        if (!(options_.guide_share > 0)) return;
        auto stops = space_.guide();
        if (stops.empty()) return;
        guide_.emplace_back(stops);
        std::reverse(stops.begin(), stops.end());
        guide_.emplace_back(std::move(stops));
    }

    /// Share of the iterations that are guided: less the longer that has been in vain.
    double guided_share(int side) const {
        if (guide_.empty()) return 0;
        const auto in_vain = static_cast<double>(guide_[static_cast<std::size_t>(side)].in_vain());
        return options_.guide_share * options_.guide_patience / (options_.guide_patience + in_vain);
    }

    Space& space_;
    const SlideAndPullOptions& options_;
    Rng& rng_;
    TwoTrees<Space> trees_;
    std::vector<RegionBias> guide_;  ///< of both trees, once there is a way
    Configurations path_;            ///< once the trees have met
    std::vector<double> target_;
    Configurations visited_;
};

/// The planner that is on by default: two trees, the smaller one grows, by steering toward a sample
/// (RRT-Connect with sliding) or by dragging one end of the chain to a point of the plane, which is
/// what gets the head of a long chain into the mouth of a corridor; the other tree then tries to
/// connect to where that came. Where the problem is not easy, both happen mostly where a tree has
/// come farthest on the shortest way through the plane (RegionBias).
template <PullableSpace Space>
SearchResult slide_and_pull(Space& space, const Query& query, const SlideAndPullOptions& options,
                            const Limits& limits, Rng& rng, const Observer& observer = {}) {
    return SlideAndPull<Space>(space, query, options, rng).search(limits, observer);
}

}  // namespace asv::core
