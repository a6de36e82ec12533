#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/search/limits.hpp"
#include "core/search/setting.hpp"
#include "core/search/trees/one_tree.hpp"
#include "core/search/trees/roadmap.hpp"

namespace asv::core {

/// How the shortest path in a roadmap is looked for; both find paths of one cost.
enum class RoadmapSearch { dijkstra, a_star };

/// What each field is, settings_of() says below.
struct PrmOptions {
    std::size_t samples = 1000;
    std::size_t draws = 200000;
    std::size_t neighbours = 10;
    double radius = 0;
    RoadmapSearch search = RoadmapSearch::a_star;
};

inline std::vector<Setting> settings_of(PrmOptions& options) {
    return {
        {.name = "samples",
         .meaning = "least number of nodes before a path is looked for",
         .value = number(options.samples, 0, 1e7),
         .why = "as reported for a point on a map; 500 for an arm, 2000 and more for Gaussian and "
                "bridge samples",
         .source = "Kavraki and others 1996"},
        {.name = "draws",
         .meaning = "draws after which a path is looked for with fewer nodes",
         .value = number(options.draws, 0, 1e12),
         .why = "a round number; bridge samples, two or three in a thousand draws, come to some "
                "hundreds by then",
         .source = "own"},
        {.name = "neighbours",
         .meaning = "nearest nodes that a node is joined to",
         .value = number(options.neighbours, 1, 1e4),
         .why = "as reported for an arm",
         .source = "Kavraki and others 1996"},
        {.name = "radius",
         .meaning = "join all nodes within it instead; 0: the nearest ones",
         .value = number(options.radius, 0, 1e4, in_metric),
         .why = "a number of neighbours suits every body and every density of nodes, a radius "
                "only one",
         .source = "Kavraki and others 1996"},
        {.name = "search",
         .meaning = "how the shortest path is found",
         .value = one_of(options.search, {"dijkstra", "a-star"}),
         .why = "looks at fewer nodes than Dijkstra, for a path of the same cost",
         .source = "Hart, Nilsson and Raphael 1968"},
    };
}

/// Joins a node to those of its neighbours that it is not connected with yet, or to all of them,
/// where the straight motion is valid.
template <SampledSpace Space>
void join_neighbours(Space& space, Roadmap& roadmap, std::uint32_t node, const PrmOptions& options,
                     bool all) {
    const auto at = roadmap.row(node);
    // One more than asked for, as the node finds itself.
    const auto found = options.radius > 0
                           ? roadmap.neighbours().within(at, options.radius)
                           : roadmap.neighbours().nearest(at, options.neighbours + 1);
    std::vector<double> other(at.size());
    for (const std::size_t index : found) {
        const auto neighbour = static_cast<std::uint32_t>(index);
        if (neighbour == node || (!all && roadmap.connected(node, neighbour))) continue;
        std::copy(roadmap.row(neighbour).begin(), roadmap.row(neighbour).end(), other.begin());
        unwrap(other, at, space.wrapping());
        if (space.motion_valid(at, other)) roadmap.join(node, neighbour, space.cost(at, other));
    }
}

/// Adds a node and joins it to its neighbours.
template <SampledSpace Space>
std::uint32_t connect(Space& space, Roadmap& roadmap, std::span<const double> row,
                      const PrmOptions& options) {
    const std::uint32_t node = roadmap.add(row);
    join_neighbours(space, roadmap, node, options, true);
    return node;
}

/// The rows of a shortest path between two nodes; empty when they are not connected.
template <SampledSpace Space>
Configurations shortest_path(Space& space, const Roadmap& roadmap, std::uint32_t from,
                             std::uint32_t to, RoadmapSearch search) {
    std::vector<double> row(space.dimension());
    const auto cost_lower_bound = [&](std::uint32_t node) {
        std::copy(roadmap.row(node).begin(), roadmap.row(node).end(), row.begin());
        unwrap(row, roadmap.row(to), space.wrapping());
        return space.cost_lower_bound(row, roadmap.row(to));
    };
    const auto nodes = search == RoadmapSearch::dijkstra
                           ? roadmap.dijkstra(from, to)
                           : roadmap.a_star(from, to, cost_lower_bound);
    return rows_along(roadmap.nodes(), nodes, space.wrapping());
}

/// The probabilistic roadmap (Kavraki, Svestka, Latombe and Overmars, 1996): samples joined to
/// their neighbours, then start and goal joined in the same way, then more samples until these are
/// connected, the ends being tried again whenever the roadmap has grown by a tenth; the path is a
/// shortest one of the roadmap. The roadmap is kept: given one of an
/// earlier query it is asked first, and sampled only up to the number there shall be at least.
template <SampledSpace Space>
SearchResult prm(Space& space, const Query& query, const PrmOptions& options, const Limits& limits,
                 Rng& rng, Roadmap& roadmap, const Observer& observer = {}) {
    SearchResult result;
    std::vector<double> row(space.dimension());
    /// Adds one sample if its draw succeeds; false when the limits are reached.
    const auto sample = [&] {
        if (must_end({result.iterations, {roadmap.size(), 0}}, limits, observer, result))
            return false;
        ++result.iterations;
        if (space.sample(rng, row)) connect(space, roadmap, row, options);
        return true;
    };

    bool going = true;
    while (going && roadmap.size() < options.samples && result.iterations < options.draws)
        going = sample();
    const std::uint32_t start = connect(space, roadmap, query.start, options);
    const std::uint32_t goal = connect(space, roadmap, query.goal, options);
    for (std::size_t tried = roadmap.size(); going && !roadmap.connected(start, goal);) {
        going = sample();
        if (roadmap.size() < tried + tried / 10 + 1) continue;
        tried = roadmap.size();
        for (const std::uint32_t end : {start, goal})
            join_neighbours(space, roadmap, end, options, false);
    }
    if (roadmap.connected(start, goal)) {
        result.outcome = Outcome::solved;
        result.path = shortest_path(space, roadmap, start, goal, options.search);
    }
    for (const Roadmap::Edge& edge : roadmap.edges()) result.edges.push_back({edge.from, edge.to});
    result.trees.push_back(roadmap.nodes());
    return result;
}

/// The same with a roadmap of its own.
template <SampledSpace Space>
SearchResult prm(Space& space, const Query& query, const PrmOptions& options, const Limits& limits,
                 Rng& rng, const Observer& observer = {}) {
    Roadmap roadmap(space.make_index());
    return prm(space, query, options, limits, rng, roadmap, observer);
}

}  // namespace asv::core
