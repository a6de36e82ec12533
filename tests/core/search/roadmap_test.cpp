#include "core/search/trees/roadmap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/search/prm.hpp"
#include "tests/kit/toy_spaces.hpp"

namespace asv::core {
namespace {

using testing::nth;
using testing::PointSpace;
using testing::Row;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The costs of the shortest paths between all nodes (Floyd, 1962).
std::vector<std::vector<double>> all_shortest(const Roadmap& roadmap) {
    const std::size_t n = roadmap.size();
    std::vector<std::vector<double>> cost(n, std::vector<double>(n, infinity));
    for (std::size_t i = 0; i < n; ++i) cost[i][i] = 0;
    for (const Roadmap::Edge& edge : roadmap.edges())
        cost[edge.from][edge.to] = cost[edge.to][edge.from] =
            std::min(cost[edge.from][edge.to], edge.cost);
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                cost[i][j] = std::min(cost[i][j], cost[i][k] + cost[k][j]);
    return cost;
}

/// The cost of a path, infinite where a motion of it is no edge.
double cost_of(const Roadmap& roadmap, const std::vector<std::uint32_t>& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        double least = infinity;
        for (const Roadmap::Edge& edge : roadmap.edges())
            if ((edge.from == path[i] && edge.to == path[i - 1]) ||
                (edge.to == path[i] && edge.from == path[i - 1]))
                least = std::min(least, edge.cost);
        sum += least;
    }
    return sum;
}

TEST(Roadmap, ShortestPathsAgreeWithBruteForce) {
    testing::for_seeds(testing::scaled(40), [](Rng& rng) {
        PointSpace space({});
        Roadmap roadmap(space.make_index());
        const std::size_t count = 2 + rng.below(40);
        for (std::size_t i = 0; i < count; ++i) roadmap.add(Row{rng.uniform(), rng.uniform()});
        const auto node = [&] { return static_cast<std::uint32_t>(rng.below(count)); };
        for (std::size_t i = rng.below(3 * count); i > 0; --i) {
            const auto a = node(), b = node();
            // At least the distance, so that it is a heuristic for A*.
            roadmap.join(a, b, space.distance(roadmap.row(a), roadmap.row(b)) + rng.uniform());
        }
        const auto expected = all_shortest(roadmap);
        for (int query = 0; query < 20; ++query) {
            const auto from = node(), to = node();
            const auto least = [&](std::uint32_t at) {
                return space.distance(roadmap.row(at), roadmap.row(to));
            };
            ASSERT_EQ(roadmap.connected(from, to), expected[from][to] < infinity);
            for (const auto& path : {roadmap.dijkstra(from, to), roadmap.a_star(from, to, least)}) {
                if (expected[from][to] == infinity) {
                    ASSERT_TRUE(path.empty());
                    continue;
                }
                ASSERT_EQ(path.front(), from);
                ASSERT_EQ(path.back(), to);
                ASSERT_NEAR(cost_of(roadmap, path), expected[from][to], 1e-9);
            }
        }
    });
}

TEST(Prm, PathsAreShortestOnTheRoadmap) {
    testing::for_seeds(testing::scaled(10), [](Rng& rng) {
        PointSpace space(testing::wall_with_door());
        const Row start{0.1, 0.1}, goal{0.9, 0.1};
        for (const auto search : {RoadmapSearch::dijkstra, RoadmapSearch::a_star}) {
            PrmOptions options;
            options.samples = 100;
            options.search = search;
            Roadmap roadmap(space.make_index());
            const auto result = prm(space, {start, goal}, options, {}, rng, roadmap);
            ASSERT_EQ(result.outcome, Outcome::solved);
            double cost = 0;
            for (std::size_t i = 1; i < result.path.size() / 2; ++i)
                cost += space.cost(nth(result.path, 2, i - 1), nth(result.path, 2, i));
            const auto end = [&](const Row& row) { return roadmap.neighbours().nearest(row); };
            // Bellman and Ford's relaxations, since the roadmap may be large.
            std::vector<double> least(roadmap.size(), infinity);
            least[end(start)] = 0;
            for (bool better = true; better;) {
                better = false;
                for (const Roadmap::Edge& edge : roadmap.edges())
                    for (const auto& [a, b] : {std::pair{edge.from, edge.to}, {edge.to, edge.from}})
                        if (least[a] + edge.cost < least[b] - 1e-12) {
                            least[b] = least[a] + edge.cost;
                            better = true;
                        }
            }
            ASSERT_NEAR(cost, least[end(goal)], 1e-9);
        }
    });
}

TEST(Prm, KeepsTheRoadmapForFurtherQueries) {
    PointSpace space(testing::wall_with_door());
    PrmOptions options;
    options.samples = 200;
    Roadmap roadmap(space.make_index());
    Rng rng(7);
    const Row a{0.1, 0.1}, b{0.9, 0.1}, c{0.2, 0.8}, d{0.8, 0.7};
    ASSERT_EQ(prm(space, {a, b}, options, {}, rng, roadmap).outcome, Outcome::solved);
    const std::size_t size = roadmap.size();
    const auto second = prm(space, {c, d}, options, {}, rng, roadmap);
    EXPECT_EQ(second.outcome, Outcome::solved);
    EXPECT_EQ(second.iterations, 0U);
    EXPECT_EQ(roadmap.size(), size + 2);
}

/// A space whose sampler finds nothing.
struct BarrenSpace : PointSpace {
    using PointSpace::PointSpace;
    bool sample(Rng&, std::span<double>) { return false; }
};

TEST(Prm, AsksTheRoadmapWithFewerSamplesAfterItsDraws) {
    BarrenSpace space(std::vector<Box>{});
    PrmOptions options;
    options.draws = 50;
    Rng rng(1);
    const auto result = prm(space, {Row{0.1, 0.1}, Row{0.9, 0.1}}, options, {}, rng);
    EXPECT_EQ(result.outcome, Outcome::solved);
    EXPECT_EQ(result.iterations, 50U);
    EXPECT_EQ(result.path, (Configurations{0.1, 0.1, 0.9, 0.1}));
}

TEST(Prm, JoinsNeighboursWithinTheRadiusOnly) {
    PointSpace space({});
    PrmOptions options;
    options.samples = 150;
    options.radius = 0.15;
    Roadmap roadmap(space.make_index());
    Rng rng(7);
    prm(space, {Row{0.1, 0.1}, Row{0.9, 0.1}}, options, {}, rng, roadmap);
    std::size_t close = 0;
    for (std::uint32_t i = 0; i < roadmap.size(); ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            if (space.distance(roadmap.row(i), roadmap.row(j)) <= options.radius) ++close;
    EXPECT_EQ(roadmap.edges().size(), close);
    for (const Roadmap::Edge& edge : roadmap.edges()) EXPECT_LE(edge.cost, options.radius + 1e-6);
}

}  // namespace
}  // namespace asv::core
