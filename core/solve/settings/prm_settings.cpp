#include "core/solve/settings/settings_of.hpp"

namespace asv::core {

std::vector<Setting> settings_of(PrmPlanner& planner) {
    PrmOptions& s = planner.search;
    return joined(
        {number("samples", s.samples, 0, 1e7, "",
                "least number of nodes before a path is looked for"),
         number("draws", s.draws, 0, 1e12, "",
                "draws after which a path is looked for with fewer nodes"),
         number("neighbours", s.neighbours, 1, 1e4, "", "nearest nodes that a node is joined to"),
         number("radius", s.radius, 0, 1e4, metric_unit,
                "join all nodes within it instead; 0: the nearest ones"),
         choice("search", s.search, {"dijkstra", "a-star"}, "how the shortest path is found")},
        settings_of(planner.sampler));
}

}  // namespace asv::core
