#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/search/extensions/extensions.hpp"
#include "core/search/limits.hpp"
#include "core/search/setting.hpp"
#include "core/search/trees/two_trees.hpp"

namespace asv::core {

/// Who grows toward what in one iteration of the bidirectional search.
enum class GrowthOrder {
    both_to_sample,   ///< both trees toward the sample
    start_then_goal,  ///< the start tree to the sample, the goal tree to where that came
    goal_then_start   ///< the goal tree to the sample, the start tree to where that came
};

struct RrtConnectOptions {
    /// The orders that take turns, one for each iteration; not empty.
    std::vector<GrowthOrder> orders = {GrowthOrder::both_to_sample, GrowthOrder::start_then_goal,
                                       GrowthOrder::goal_then_start};
};

/// Is the order among those that take turns? An order that is switched on comes last.
inline SettingValue takes_turns(std::vector<GrowthOrder>& orders, GrowthOrder order) {
    return {.low = 0,
            .high = 1,
            .whole = true,
            .get = [&orders, order] { return std::ranges::count(orders, order) > 0 ? 1.0 : 0.0; },
            .set =
                [&orders, order](double on) {
                    std::erase(orders, order);
                    if (on != 0) orders.push_back(order);
                }};
}

inline std::vector<Setting> settings_of(RrtConnectOptions& options) {
    return {
        {.name = "order-both",
         .meaning = "grow both trees to the sample",
         .value = takes_turns(options.orders, GrowthOrder::both_to_sample),
         .why = "three orders by turns, as reported; off leaves the two of the textbook",
         .source = "report on the bidirectional RRT for ASVs"},
        {.name = "order-start",
         .meaning = "grow the start tree to the sample, the goal tree to where that came",
         .value = takes_turns(options.orders, GrowthOrder::start_then_goal),
         .why = "neither end is preferred",
         .source = "Kuffner and LaValle 2000"},
        {.name = "order-goal",
         .meaning = "grow the goal tree to the sample, the start tree to where that came",
         .value = takes_turns(options.orders, GrowthOrder::goal_then_start),
         .why = "neither end is preferred",
         .source = "Kuffner and LaValle 2000"},
    };
}

/// RRT-Connect (Kuffner and LaValle, 2000): two trees, each extended by steering until it is
/// reached or blocked, until they meet. Extensions take part in drawing the sample, in choosing the
/// node to grow from and in when the next order has its turn.
template <ConfigurationSpace Space, class Policy = NoExtensions>
SearchResult rrt_connect(Space& space, const Query& query, const RrtConnectOptions& options,
                         const Limits& limits, Rng& rng, const Observer& observer = {},
                         Policy extensions = {}) {
    TwoTrees<Space> trees(space, query);
    SearchResult result;
    std::vector<double> sample(query.goal.begin(), query.goal.end());

    const auto grow = [&](int side, std::span<const double> target) {
        const std::uint32_t from = extensions.nearest(trees[side], side, target);
        const auto growth = trees.grow(side, from, target);
        extensions.grown(space, trees[side], side, from, growth.outcome, growth.last);
        return growth;
    };
    const auto meet = [&](int first, std::span<const double> target, bool chase) {
        const auto grown = grow(first, target);
        if (chase && grown.outcome == Steered::trapped) return false;
        // A copy, since growing the other tree must not depend on where rows of this one lie.
        const auto row = trees[first].row(grown.last);
        const std::vector<double> met(row.begin(), row.end());
        const auto answer = grow(1 - first, chase ? std::span<const double>(met) : target);
        const bool both = chase || grown.outcome == Steered::reached;
        if (!both || answer.outcome != Steered::reached) return false;
        result.path =
            first == 0 ? trees.join(grown.last, answer.last) : trees.join(answer.last, grown.last);
        return true;
    };

    std::size_t turn = 0;
    const auto direct = trees.grow(0, query.goal);
    bool met = direct.outcome == Steered::reached;
    if (met) result.path = trees.join(direct.last, 0);
    while (!met) {
        const Progress progress = trees.progress(result.iterations);
        if (observer) observer(progress);
        if (const auto reason = limits.reached(progress)) {
            result.outcome = *reason;
            break;
        }
        if (result.iterations++ > 0 && extensions.swaps()) ++turn;
        const GrowthOrder order = options.orders[turn % options.orders.size()];
        const int first = order == GrowthOrder::goal_then_start ? 1 : 0;
        if (extensions.draw(space, trees, first, rng, sample))
            met = meet(first, sample, order != GrowthOrder::both_to_sample);
    }
    if (met) result.outcome = Outcome::solved;
    result.trees = trees.release();
    return result;
}

}  // namespace asv::core
