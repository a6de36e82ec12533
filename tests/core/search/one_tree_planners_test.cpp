#include <chrono>
#include <stop_token>
#include <vector>

#include "core/search/prm.hpp"
#include "core/search/rrt.hpp"
#include "core/search/rrt_star.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_planners.hpp"

/// What rrt, rrt_star and prm have in common.

namespace asv::core {
namespace {

using test::goal;
using test::PointSpace;
using test::start;

SearchResult by_rrt(PointSpace& space, const Limits& limits, Rng& rng, const Observer& observer) {
    return rrt(space, {start, goal}, {}, limits, rng, observer);
}
SearchResult by_rrt_star(PointSpace& space, const Limits& limits, Rng& rng,
                         const Observer& observer) {
    RrtStarOptions options;
    options.nodes = 700;
    return rrt_star(space, {start, goal}, options, limits, rng, observer);
}
SearchResult by_prm(PointSpace& space, const Limits& limits, Rng& rng, const Observer& observer) {
    PrmOptions options;
    options.samples = 200;
    return prm(space, {start, goal}, options, limits, rng, observer);
}
SearchResult by_radius_prm(PointSpace& space, const Limits& limits, Rng& rng,
                           const Observer& observer) {
    PrmOptions options;
    options.samples = 200;
    options.radius = 0.1;
    options.search = RoadmapSearch::dijkstra;
    return prm(space, {start, goal}, options, limits, rng, observer);
}

const test::ToyPlanner planners[] = {
    {"Rrt", by_rrt}, {"RrtStar", by_rrt_star}, {"Prm", by_prm}, {"PrmRadius", by_radius_prm}};

struct EachSampledPlanner : test::ToyPlannerTest {};

TEST_P(EachSampledPlanner, FindsTheDoor) {
    test::for_seeds(test::scaled(10), [&](Rng& rng) {
        PointSpace space(test::wall_with_door());
        test::expect_way(space, plan(space, rng.bits()));
    });
}

TEST_P(EachSampledPlanner, SameSeedSamePathWatchedOrNot) {
    PointSpace space(test::wall_with_door());
    std::size_t seen = 0;
    const SearchResult a = plan(space, 5);
    const SearchResult b = plan(space, 5, {}, [&](const Progress& progress) {
        EXPECT_EQ(progress.iterations, seen);
        ++seen;
    });
    EXPECT_EQ(a.path, b.path);
    EXPECT_EQ(a.iterations, b.iterations);
    EXPECT_GE(seen, b.iterations);
    EXPECT_NE(a.path, plan(space, 6).path);
}

TEST_P(EachSampledPlanner, StopsAtItsLimits) {
    PointSpace space(test::closed_wall());
    Limits limits;
    limits.max_iterations = 377;
    SearchResult result = plan(space, 1, limits);
    EXPECT_EQ(result.outcome, Outcome::iterations);
    EXPECT_EQ(result.iterations, 377U);
    EXPECT_TRUE(result.path.empty());

    limits = {};
    limits.max_nodes = 100;
    result = plan(space, 1, limits);
    EXPECT_EQ(result.outcome, Outcome::nodes);
    EXPECT_GE(result.trees[0].size(), 100U);
    EXPECT_LE(result.trees[0].size(), 102U);

    limits = {};
    limits.deadline = Clock::now() + std::chrono::milliseconds(20);
    EXPECT_EQ(plan(space, 1, limits).outcome, Outcome::deadline);

    limits = {};
    std::stop_source source;
    limits.stop = source.get_token();
    result = plan(space, 1, limits, [&](const Progress& progress) {
        if (progress.iterations == 10) source.request_stop();
    });
    EXPECT_EQ(result.outcome, Outcome::stopped);
    EXPECT_EQ(result.iterations, 10U);
}

TEST_P(EachSampledPlanner, EdgesAreValid) {
    PointSpace space(test::wall_with_door());
    const SearchResult result = plan(space, 3);
    ASSERT_EQ(result.trees.size(), 1U);
    const Tree& tree = result.trees[0];
    std::size_t edges = 0;
    for (std::uint32_t node = 0; node < tree.size(); ++node) {
        if (tree.parent(node) == Tree::none) continue;
        ++edges;
        ASSERT_TRUE(space.free(tree.row(tree.parent(node)), tree.row(node)));
    }
    for (const auto& [a, b] : result.edges) {
        ++edges;
        ASSERT_TRUE(space.free(tree.row(a), tree.row(b)));
    }
    EXPECT_GE(edges + 1, tree.size());
}

INSTANTIATE_TEST_SUITE_P(Toy, EachSampledPlanner, ::testing::ValuesIn(planners),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace asv::core
