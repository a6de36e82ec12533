#include "core/search/prm.hpp"

#include <limits>
#include <vector>

#include "core/model/problem.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_planners.hpp"

namespace asv::core {
namespace {

using test::goal;
using test::nth;
using test::PointSpace;
using test::Row;
using test::start;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Prm, PathsAreShortestOnTheRoadmap) {
    test::for_seeds(test::scaled(10), [](Rng& rng) {
        PointSpace space(test::wall_with_door());
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
    PointSpace space(test::wall_with_door());
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
