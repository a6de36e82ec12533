#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
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
/// One search of rrt_connect(): the trees, and the steps of the algorithm by their names.
template <ConfigurationSpace Space, class Policy>
class RrtConnect {
  public:
    RrtConnect(Space& space, const Query& query, const RrtConnectOptions& options, Rng& rng,
               Policy extensions)
        : space_(space),
          options_(options),
          rng_(rng),
          extensions_(std::move(extensions)),
          trees_(space, query),
          sample_(query.goal.begin(), query.goal.end()) {}

    SearchResult search(const Limits& limits, const Observer& observer) {
        SearchResult result;
        bool met = connect_directly();
        while (!met) {
            if (must_end(trees_.progress(result.iterations), limits, observer, result)) break;
            if (result.iterations++ > 0 && extensions_.swaps()) ++turn_;
            const GrowthOrder order = options_.orders[turn_ % options_.orders.size()];
            const int first = order == GrowthOrder::goal_then_start ? goal_tree : start_tree;
            if (!extensions_.draw(space_, trees_, first, rng_, sample_)) continue;
            met = order == GrowthOrder::both_to_sample ? meet_at_sample() : chase(first);
        }
        if (met) result.outcome = Outcome::solved;
        result.path = std::move(path_);
        result.trees = trees_.release();
        return result;
    }

  private:
    using Growth = typename TwoTrees<Space>::Growth;
    static constexpr int start_tree = 0, goal_tree = 1;
    static constexpr std::uint32_t root = 0;

    /// The straight way from the start to the goal comes first.
    bool connect_directly() {
        const Growth growth = trees_.grow(start_tree, sample_);
        return growth.outcome == Steered::reached && join(start_tree, growth.last, root);
    }

    /// CONNECT of the paper: extends a tree from its nearest node until the target is reached or
    /// the way is blocked.
    Growth connect(int side, std::span<const double> target) {
        const std::uint32_t from = extensions_.nearest(trees_[side], side, target);
        const Growth growth = trees_.grow(side, from, target);
        extensions_.grown(space_, trees_[side], side, from, growth.outcome, growth.last);
        return growth;
    }

    /// Both trees grow to the sample.
    bool meet_at_sample() {
        const Growth one = connect(start_tree, sample_);
        const Growth other = connect(goal_tree, sample_);
        const bool both = one.outcome == Steered::reached && other.outcome == Steered::reached;
        return both && join(start_tree, one.last, other.last);
    }

    /// One tree grows to the sample, the other one to where that came.
    bool chase(int first) {
        const Growth grown = connect(first, sample_);
        if (grown.outcome == Steered::trapped) return false;
        // A copy, since growing the other tree must not depend on where rows of this one lie.
        const auto row = trees_[first].row(grown.last);
        const std::vector<double> target(row.begin(), row.end());
        const Growth answer = connect(1 - first, target);
        return answer.outcome == Steered::reached && join(first, grown.last, answer.last);
    }

    /// The trees have met at two nodes of one configuration.
    bool join(int side, std::uint32_t node, std::uint32_t in_other_tree) {
        path_ = side == start_tree ? trees_.join(node, in_other_tree)
                                   : trees_.join(in_other_tree, node);
        return true;
    }

    Space& space_;
    const RrtConnectOptions& options_;
    Rng& rng_;
    Policy extensions_;
    TwoTrees<Space> trees_;
    std::size_t turn_ = 0;
    std::vector<double> sample_;
    Configurations path_;
};

/// RRT-Connect (Kuffner and LaValle, 2000): two trees, each extended by steering until it is
/// reached or blocked, until they meet. Extensions take part in drawing the sample, in choosing the
/// node to grow from and in when the next order has its turn.
template <ConfigurationSpace Space, class Policy = NoExtensions>
SearchResult rrt_connect(Space& space, const Query& query, const RrtConnectOptions& options,
                         const Limits& limits, Rng& rng, const Observer& observer = {},
                         Policy extensions = {}) {
    return RrtConnect<Space, Policy>(space, query, options, rng, std::move(extensions))
        .search(limits, observer);
}

}  // namespace asv::core
