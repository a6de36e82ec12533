#include "core/search/trees/roadmap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_spaces.hpp"

namespace asv::core {
namespace {

using test::PointSpace;
using test::Row;

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
    test::for_seeds(test::scaled(40), [](Rng& rng) {
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

}  // namespace
}  // namespace asv::core
