#pragma once

#include <algorithm>
#include <cmath>
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
#include "geometry/primitives.hpp"

namespace asv::core {

/// Options of the search by slides and pulls. What each field is, settings_of() says below.
struct SlideAndPullOptions {
    double pull_share = 0.5;
    double guide_share = 0.8;
    double guide_patience = 5;
    double passage_share = 0.5;
    std::size_t pull_candidates = 24;
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

/// The planner that is on by default: two trees, the smaller one grows, by steering toward a sample
/// (RRT-Connect with sliding) or by dragging one end of the chain to a point of the plane, which is
/// what gets the head of a long chain into the mouth of a corridor; the other tree then tries to
/// connect to where that came. Where the problem is not easy, both happen mostly where a tree has
/// come farthest on the shortest way through the plane (RegionBias).
template <PullableSpace Space>
SearchResult slide_and_pull(Space& space, const Query& query, const SlideAndPullOptions& options,
                            const Limits& limits, Rng& rng, const Observer& observer = {}) {
    TwoTrees<Space> trees(space, query);
    SearchResult result;
    std::vector<double> target(query.goal.begin(), query.goal.end());
    Configurations visited;

    // What grows a tree gives the new node, if it moved at all.
    const auto drag = [&](int side, std::uint32_t node, std::size_t end,
                          const geometry::Point& point) -> std::optional<std::uint32_t> {
        visited.clear();
        if (space.pull(trees[side].row(node), end, point, visited) == Steered::trapped)
            return std::nullopt;
        return trees.add(side, node, visited);
    };
    const auto steer_to_target = [&](int side) -> std::optional<std::uint32_t> {
        const auto grown = trees.grow(side, target);
        if (grown.outcome == Steered::trapped) return std::nullopt;
        return grown.last;
    };
    const auto draw_end = [&] { return rng.chance(0.5) ? 0 : space.asv_count() - 1; };
    /// Drags an end of a node that is near a point there.
    const auto pull = [&](int side) -> std::optional<std::uint32_t> {
        const auto point = space.pull_target(rng, options.passage_share);
        if (!point) return std::nullopt;
        const std::size_t end = draw_end();
        const Tree& tree = trees[side];
        std::uint32_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < options.pull_candidates; ++i) {
            const auto node = static_cast<std::uint32_t>(rng.below(tree.size()));
            const geometry::Point at = space.position(tree.row(node), end);
            const double distance = std::hypot(at.x - point->x, at.y - point->y);
            if (distance < least) {
                least = distance;
                best = node;
            }
        }
        return drag(side, best, end, *point);
    };
    const auto extend = [&](int side) -> std::optional<std::uint32_t> {
        if (!space.sample(rng, target)) return std::nullopt;
        return steer_to_target(side);
    };
    std::vector<RegionBias> bias;  ///< of both trees, where there is a way
    const auto look_for_guide = [&] {
        auto stops = space.guide();
        if (stops.empty()) return;
        bias.emplace_back(stops);
        std::reverse(stops.begin(), stops.end());
        bias.emplace_back(std::move(stops));
    };
    const auto guided_share = [&](int side) {
        if (bias.empty()) return 0.0;
        const auto in_vain = static_cast<double>(bias[static_cast<std::size_t>(side)].in_vain());
        return options.guide_share * options.guide_patience / (options.guide_patience + in_vain);
    };
    /// Grows a tree where it has come farthest on the shortest way.
    const auto advance = [&](int side) -> std::optional<std::uint32_t> {
        RegionBias& ours = bias[static_cast<std::size_t>(side)];
        ours.follow(trees[side],
                    [&](auto row) { return space.position(row, space.asv_count() / 2); });
        const std::size_t region = ours.region(rng);
        const geometry::Point& ahead = ours.ahead(region, rng);
        if (rng.chance(options.pull_share)) {
            const std::uint32_t node = ours.node_at(region, rng);
            return drag(side, node, draw_end(), ahead);
        }
        if (!space.sample_near(rng, ahead, target)) return std::nullopt;
        return steer_to_target(side);
    };
    /// Lets the other tree reach for the node.
    const auto connect = [&](int side, std::uint32_t node) {
        const auto row = trees[side].row(node);
        target.assign(row.begin(), row.end());
        const auto grown = trees.grow(1 - side, target);
        if (grown.outcome != Steered::reached) return false;
        result.path = side == 0 ? trees.join(node, grown.last) : trees.join(grown.last, node);
        return true;
    };

    bool met = connect(1, 0);
    while (!met) {
        const Progress progress = trees.progress(result.iterations);
        if (observer) observer(progress);
        if (const auto reason = limits.reached(progress)) {
            result.outcome = *reason;
            break;
        }
        ++result.iterations;
        const int side = trees[0].size() <= trees[1].size() ? 0 : 1;
        if (result.iterations == unguided_iterations && options.guide_share > 0) look_for_guide();
        const auto node = rng.chance(guided_share(side))   ? advance(side)
                          : rng.chance(options.pull_share) ? pull(side)
                                                           : extend(side);
        met = node && connect(side, *node);
    }
    if (met) result.outcome = Outcome::solved;
    result.trees = trees.release();
    return result;
}

}  // namespace asv::core
