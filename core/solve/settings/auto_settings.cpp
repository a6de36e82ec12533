#include "core/solve/settings/settings_of.hpp"

namespace asv::core {

std::vector<Setting> settings_of(AutoPlanner& planner) {
    SlideOptions& s = planner.steering;
    SlideAndPullOptions& p = planner.search;
    return {
        flag("slide", s.slide, "slide along what blocks a straight motion"),
        number("slide-step", s.step, 1e-4, 0.5, "workspace units",
               "longest constrained step, root mean square motion of the ASVs"),
        number("slide-margin", s.margin, 1e-6, 0.1, "workspace units",
               "gap kept to obstacles where there is room"),
        number("slide-hair", s.hair, 1e-7, 0.01, "workspace units",
               "least gap, where the place is tight"),
        number("slide-progress", s.progress, 0, 1, "",
               "share of its length by which a constrained step has to come nearer"),
        number("slide-steps", s.max_steps, 1, 1e6, "", "most constrained steps of one slide"),
        number("pull-share", p.pull_share, 0, 1, "", "share of the iterations that pull"),
        number("guide-share", p.guide_share, 0, 1, "",
               "share of the iterations that grow a tree along the shortest way of one ASV"),
        number("guide-patience", p.guide_patience, 0.01, 1e9, "",
               "such iterations in vain after which that share has halved"),
        number("passage-share", p.passage_share, 0, 1, "",
               "share of the pulls whose target lies in a passage (bridge test)"),
        number("pull-candidates", p.pull_candidates, 1, 1e4, "",
               "nodes of which the most promising one is pulled"),
    };
}

}  // namespace asv::core
