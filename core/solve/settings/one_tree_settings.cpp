#include "core/solve/settings/settings_of.hpp"

namespace asv::core {

std::vector<Setting> settings_of(RrtPlanner& planner) {
    RrtOptions& s = planner.search;
    return joined({number("step", s.step, 0, 1e4, metric_unit,
                          "longest motion of an extension; 0: a tenth of the longest side"),
                   number("goal-bias", s.goal_bias, 0, 1, "",
                          "share of the samples that are the "
                          "goal")},
                  settings_of(planner.sampler));
}

std::vector<Setting> settings_of(RrtStarPlanner& planner) {
    RrtStarOptions& s = planner.search;
    return joined(
        {number("step", s.step, 0, 1e4, metric_unit,
                "longest motion of an extension; 0: a tenth of the longest side"),
         number("goal-bias", s.goal_bias, 0, 1, "",
                "share of the samples that are the goal until it is reached"),
         number("radius", s.radius, 0, 1e4, metric_unit,
                "of the neighbours; 0: gamma (log n / n)^(1/dimension), at most a step"),
         number("gamma", s.gamma, 0, 1e4, metric_unit,
                "of that formula; 0: the least one of the theory"),
         number("nodes", s.nodes, 2, 1e7, "", "nodes after which it stops to improve its path")},
        settings_of(planner.sampler));
}

}  // namespace asv::core
