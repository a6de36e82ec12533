#include <algorithm>
#include <utility>

#include "core/solve/settings/settings_of.hpp"

namespace asv::core {

namespace {

/// An order of growing the trees that can be taken out of the rotation.
Setting order(std::string name, std::vector<GrowthOrder>& orders, GrowthOrder which,
              std::string meaning) {
    return {std::move(name),
            std::move(meaning),
            "",
            0,
            1,
            true,
            [&orders, which] {
                return std::count(orders.begin(), orders.end(), which) > 0 ? 1.0 : 0.0;
            },
            [&orders, which](double on) {
                std::erase(orders, which);
                if (on != 0) orders.push_back(which);
            }};
}

/// The seven extensions.
std::vector<Setting> settings_of(ExtensionOptions& e) {
    return {
        flag("swap-limiter", e.swap_limiter, "extension 1: swap the trees after some steps"),
        number("swap-steps", e.swap_steps, 0, 1e9, "", "steps after which the limiter swaps"),
        number("swap-step", e.swap_step, 0, 1e3, metric_unit,
               "length that counts as a step; 0: a thousandth of the longest side"),
        flag("collision-swap", e.collision_swap,
             "extension 2: swap the trees only after a connect that ended in a collision"),
        choice("exhaustion", e.exhaustion.kind, {"off", "plain", "heuristic"},
               "extension 3: drop nodes that failed, or scale their distance by their fails"),
        number("drop-after", e.exhaustion.drop_after, 1, 1e9, "",
               "fails after which plain exhaustion drops a node"),
        number("fails-centre", e.exhaustion.centre, 1, 1e6, "",
               "fails at which heuristic exhaustion prefers a node most, C"),
        number("fails-share", e.exhaustion.share, 0, 1, "",
               "share of the distance by which it does"),
        flag("neighbour-cost", e.neighbour_cost,
             "extension 4: keep samples by the quality of their nearest node"),
        number("quality-floor", e.quality_floor, 0, 1, "", "least probability of keeping one"),
        flag("passage-filter", e.passage,
             "extension 5: keep samples around which some, but not all, draws collide"),
        number("filter-draws", e.passage_filter.displacements, 0, 1000, "",
               "draws around a sample that the filter looks at"),
        number("filter-sigma", e.passage_filter.sigma, 0, 1e3, metric_unit,
               "their deviation; 0: a twentieth of the longest side"),
        flag("control-chosen", e.control_chosen,
             "extension 6: keep samples that are not farther from the goal than the start"),
        number("control-reach", e.control_reach, 0, 1e3, "", "what that distance is multiplied by"),
        flag("goal-bias", e.goal_bias, "extension 7: sometimes sample the other tree's root"),
        number("goal-probability", e.goal_probability, 0, 1, "", "how often"),
    };
}

}  // namespace

std::vector<Setting> settings_of(RrtConnectPlanner& planner) {
    LadderOptions& c = planner.space;
    auto& orders = planner.search.orders;
    std::vector<Setting> own{
        flag("stepwise", c.stepwise, "sample dimension by dimension from anywhere"),
        flag("corridor", c.corridor, "sample with ASV 1 in a gap between obstacles"),
        flag("corridor-reversed", c.corridor_reversed,
             "sample with the last ASV in a gap between obstacles"),
        number("widest-corridor", c.widest_corridor, 1e-3, 10, "workspace units",
               "gap between obstacles that counts as a corridor"),
        flag("limit-angles", c.limit_angles,
             "sample no turn sharper than the sharpest of start and goal"),
        number("lift-after", c.lift_after, 1, 1e6, "",
               "failed samples in a row that lift the limit of angles"),
        number("lifted-for", c.lifted_for, 1, 1e6, "", "samples for which it stays lifted"),
        number("heading-weight", c.heading_weight, 0, 100, "units/radian",
               "weight of the heading in the distance"),
        flag("enlarge", c.enlarge, "angle enlargement where an extension is blocked"),
        number("enlarge-tries", c.enlarge_tries, 1, 1000, "",
               "how often the angles open a little more"),
        number("enlarge-share", c.enlarge_share, 1e-4, 0.9, "",
               "share by which the turns shrink each time"),
        flag("ladder", c.ladder, "ladder moves where an extension is blocked"),
        number("step", c.step, 1e-5, 0.1, "workspace units",
               "resolution of an extension, largest motion of an ASV"),
        order("order-both", orders, GrowthOrder::both_to_sample, "grow both trees to the sample"),
        order("order-start", orders, GrowthOrder::start_then_goal,
              "grow the start tree to the sample, the goal tree to where that came"),
        order("order-goal", orders, GrowthOrder::goal_then_start,
              "grow the goal tree to the sample, the start tree to where that came"),
    };
    return joined(joined(std::move(own), settings_of(planner.extensions)),
                  settings_of(planner.sampler));
}

}  // namespace asv::core
