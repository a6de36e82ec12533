#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/search/limits.hpp"
#include "core/search/setting.hpp"
#include "core/search/trees/one_tree.hpp"

namespace asv::core {

/// What each field is, settings_of() says below.
struct RrtOptions {
    double step = 0.1;
    double goal_bias = 0.05;
};

inline std::vector<Setting> settings_of(RrtOptions& options) {
    return {
        {.name = "step",
         .meaning = "longest motion of an extension; 0: a tenth of the longest side",
         .value = number(options.step, 0, 1e4, in_metric),
         .why = "a tenth of the side, a round number, suits every body; rrt() itself, which knows "
                "no sides, has 0.1",
         .source = "LaValle 1998"},
        {.name = "goal-bias",
         .meaning = "share of the samples that are the goal",
         .value = number(options.goal_bias, 0, 1),
         .why = "5 %, as reported for a point on a map",
         .source = "LaValle 1998"},
    };
}

/// The rapidly-exploring random tree (LaValle, 1998): a tree from the start, extended by one step
/// from its nearest node toward a sample where that straight motion is valid, until a node within
/// one step of the goal can be joined to it. The straight motion from start to goal comes first.
template <SampledSpace Space>
SearchResult rrt(Space& space, const Query& query, const RrtOptions& options, const Limits& limits,
                 Rng& rng, const Observer& observer = {}) {
    Tree tree(space.make_index());
    SearchResult result;
    std::vector<double> row(query.goal.begin(), query.goal.end());
    const auto to_goal = [&](std::uint32_t node) {
        std::copy(query.goal.begin(), query.goal.end(), row.begin());
        unwrap(row, tree.row(node), space.wrapping());
    };

    std::uint32_t newest = tree.add(query.start, Tree::none);
    to_goal(newest);
    bool met = space.motion_valid(query.start, row);
    while (!met) {
        if (must_end({result.iterations, {tree.size(), 0}}, limits, observer, result)) break;
        ++result.iterations;
        if (rng.chance(options.goal_bias))
            std::copy(query.goal.begin(), query.goal.end(), row.begin());
        else if (!space.sample(rng, row))
            continue;
        const std::uint32_t nearest = step_toward(space, tree, options.step, row);
        if (!space.motion_valid(tree.row(nearest), row)) continue;
        newest = tree.add(row, nearest);
        to_goal(newest);
        met = space.distance(tree.row(newest), row) <= options.step &&
              space.motion_valid(tree.row(newest), row);
    }
    if (met) {
        result.outcome = Outcome::solved;
        result.path = path_to(tree, tree.add(query.goal, newest), space.wrapping());
    }
    result.trees.push_back(std::move(tree));
    return result;
}

}  // namespace asv::core
