#include "core/search/trees/roadmap.hpp"

#include <algorithm>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

namespace asv::core {

namespace {

using Graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                          boost::property<boost::edge_weight_t, double>>;

Graph graph_of(const Roadmap& roadmap) {
    Graph graph(roadmap.size());
    for (const Roadmap::Edge& edge : roadmap.edges())
        boost::add_edge(edge.from, edge.to, edge.cost, graph);
    return graph;
}

/// Thrown to end a search of Boost.Graph, which has no other way.
struct Arrived {};

/// Ends the search when the node is taken off the queue: then its path is the shortest.
template <class Visitor>
struct UntilArrival : Visitor {
    explicit UntilArrival(std::uint32_t node) : to(node) {}
    void examine_vertex(std::size_t node, const Graph&) {
        if (node == to) throw Arrived{};
    }
    std::uint32_t to;
};

/// Runs search(graph, predecessors), which throws Arrived, and follows the predecessors back.
template <class Search>
std::vector<std::uint32_t> shortest(const Roadmap& roadmap, std::uint32_t from, std::uint32_t to,
                                    Search&& search) {
    const Graph graph = graph_of(roadmap);
    std::vector<std::size_t> predecessors(roadmap.size());
    try {
        search(graph, predecessors.data());
        return {};
    } catch (const Arrived&) {
    }
    std::vector<std::uint32_t> path{to};
    while (path.back() != from)
        path.push_back(static_cast<std::uint32_t>(predecessors[path.back()]));
    std::reverse(path.begin(), path.end());
    return path;
}

}  // namespace

std::uint32_t Roadmap::add(std::span<const double> row) {
    const std::uint32_t node = nodes_.add(row, Tree::none);
    leaders_.push_back(node);
    return node;
}

void Roadmap::join(std::uint32_t from, std::uint32_t to, double cost) {
    edges_.push_back({from, to, cost});
    leaders_[component(from)] = component(to);
}

bool Roadmap::connected(std::uint32_t from, std::uint32_t to) const {
    return component(from) == component(to);
}

std::uint32_t Roadmap::component(std::uint32_t node) const {
    while (leaders_[node] != node) node = leaders_[node] = leaders_[leaders_[node]];
    return node;
}

std::vector<std::uint32_t> Roadmap::dijkstra(std::uint32_t from, std::uint32_t to) const {
    return shortest(*this, from, to, [&](const Graph& graph, std::size_t* predecessors) {
        boost::dijkstra_shortest_paths(graph, from,
                                       boost::predecessor_map(predecessors)
                                           .visitor(UntilArrival<boost::dijkstra_visitor<>>(to)));
    });
}

std::vector<std::uint32_t> Roadmap::a_star(
    std::uint32_t from, std::uint32_t to,
    const std::function<double(std::uint32_t)>& cost_lower_bound) const {
    return shortest(*this, from, to, [&](const Graph& graph, std::size_t* predecessors) {
        boost::astar_search(
            graph, from,
            [&](std::size_t node) { return cost_lower_bound(static_cast<std::uint32_t>(node)); },
            boost::predecessor_map(predecessors).visitor(UntilArrival<boost::astar_visitor<>>(to)));
    });
}

}  // namespace asv::core
