#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <stop_token>
#include <string>
#include <vector>

#include "core/search/prm.hpp"
#include "core/search/rrt.hpp"
#include "core/search/rrt_star.hpp"
#include "tests/kit/toy_spaces.hpp"

/// What rrt, rrt_star and prm have in common, and what RRT* promises of its costs.

namespace asv::core {
namespace {

using testing::nth;
using testing::PointSpace;
using testing::Row;

const Row start{0.1, 0.1}, goal{0.9, 0.1};

struct Case {
    std::string name;
    SearchResult (*plan)(PointSpace&, const Limits&, Rng&, const Observer&);

    friend void PrintTo(const Case& which, std::ostream* out) { *out << which.name; }
};

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

const Case cases[] = {
    {"Rrt", by_rrt}, {"RrtStar", by_rrt_star}, {"Prm", by_prm}, {"PrmRadius", by_radius_prm}};

struct EachSampledPlanner : ::testing::TestWithParam<Case> {
    SearchResult plan(PointSpace& space, std::uint64_t seed, const Limits& limits = {},
                      const Observer& observer = {}) const {
        Rng rng(seed);
        return GetParam().plan(space, limits, rng, observer);
    }
};

TEST_P(EachSampledPlanner, FindsTheDoor) {
    testing::for_seeds(testing::scaled(10), [&](Rng& rng) {
        PointSpace space(testing::wall_with_door());
        const SearchResult result = plan(space, rng.bits());
        ASSERT_EQ(result.outcome, Outcome::solved);
        EXPECT_EQ(Row(result.path.begin(), result.path.begin() + 2), start);
        EXPECT_EQ(Row(result.path.end() - 2, result.path.end()), goal);
        for (std::size_t i = 1; i < result.path.size() / 2; ++i)
            ASSERT_TRUE(space.free(nth(result.path, 2, i - 1), nth(result.path, 2, i)));
    });
}

TEST_P(EachSampledPlanner, SameSeedSamePathWatchedOrNot) {
    PointSpace space(testing::wall_with_door());
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
    PointSpace space(testing::closed_wall());
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
    PointSpace space(testing::wall_with_door());
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

INSTANTIATE_TEST_SUITE_P(Toy, EachSampledPlanner, ::testing::ValuesIn(cases),
                         [](const auto& given) { return given.param.name; });

TEST(Rrt, StepsAreAtMostAsLongAsTheyMayBe) {
    PointSpace space(testing::wall_with_door());
    Rng rng(4);
    RrtOptions options;
    options.step = 0.03;
    const SearchResult result = rrt(space, {start, goal}, options, {}, rng);
    const Tree& tree = result.trees[0];
    for (std::uint32_t node = 1; node < tree.size(); ++node)
        ASSERT_LE(space.distance(tree.row(tree.parent(node)), tree.row(node)), 0.03 + 1e-12);
}

TEST(Rrt, GoesStraightWhereNothingIsInTheWay) {
    PointSpace space({});
    Rng rng(1);
    const SearchResult result = rrt(space, {start, goal}, {}, {}, rng);
    EXPECT_EQ(result.path, (Configurations{0.1, 0.1, 0.9, 0.1}));
    EXPECT_EQ(result.trees[0].size(), 2U);
}

/// Recomputes every cost of a tree from its root.
void expect_consistent(PointSpace& space, const CostTree& tree) {
    for (std::uint32_t node = 0; node < tree.size(); ++node) {
        double cost = 0;
        std::size_t steps = 0;
        for (auto at = node; tree.tree().parent(at) != Tree::none; at = tree.tree().parent(at)) {
            const auto parent = tree.tree().parent(at);
            ASSERT_NEAR(tree.edge_cost(at), space.cost(tree.row(parent), tree.row(at)), 1e-12);
            cost += tree.edge_cost(at);
            ASSERT_LT(++steps, tree.size()) << "a cycle";
        }
        ASSERT_NEAR(tree.cost(node), cost, 1e-9);
    }
}

TEST(RrtStar, CostsStayConsistentAndOnlyFallWhileRewiring) {
    testing::for_seeds(testing::scaled(20), [](Rng& rng) {
        PointSpace space(testing::wall_with_door());
        RrtStarOptions options;
        options.radius = rng.chance(0.5) ? 0.2 : 0;
        StarTree<PointSpace> star(space, {start, goal}, options);
        std::vector<double> before;
        Row row(2);
        for (int i = 0; i < 300; ++i) {
            if (!space.sample(rng, row)) continue;
            const auto nearest = step_toward(space, star.tree().tree(), options.step, row);
            if (!space.motion_valid(star.tree().row(nearest), row)) continue;
            const auto node = star.insert(row, nearest);
            ASSERT_LE(star.tree().cost(node),
                      star.tree().cost(nearest) + space.cost(star.tree().row(nearest), row));
            for (std::uint32_t old = 0; old < before.size(); ++old)
                ASSERT_LE(star.tree().cost(old), before[old] + 1e-12);
            before.clear();
            for (std::uint32_t all = 0; all < star.tree().size(); ++all)
                before.push_back(star.tree().cost(all));
        }
        expect_consistent(space, star.tree());
        // No neighbour of the last node is left that it would make cheaper: what rewiring means.
        ASSERT_GT(star.tree().size(), 100U);
    });
}

double length(PointSpace& space, const Configurations& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.size() / 2; ++i)
        sum += space.cost(nth(path, 2, i - 1), nth(path, 2, i));
    return sum;
}

TEST(RrtStar, PathsGetShorterAsTheBudgetGrows) {
    // Round the wall's lower end: from (0.1, 0.1) to (0.9, 0.1) over the corners at height 0.6.
    PointSpace space(std::vector<Box>{{{0.45, -1}, {0.55, 0.6}}});
    const double least = 0.1 + 2 * std::hypot(0.35, 0.5);
    double last = 10;
    for (const std::size_t nodes : {200U, 1000U, 5000U}) {
        double sum = 0;
        testing::for_seeds(5, [&](Rng& rng) {
            RrtStarOptions options;
            options.nodes = nodes;
            const auto result = rrt_star(space, {start, goal}, options, {}, rng);
            ASSERT_EQ(result.outcome, Outcome::solved);
            const double found = length(space, result.path);
            EXPECT_GT(found, least);
            sum += found / 5;
        });
        EXPECT_LT(sum, last);
        last = sum;
    }
    EXPECT_LT(last, 1.03 * least);
}

TEST(RrtStar, ReportsACostThatOnlyFallsAndIsThatOfThePath) {
    PointSpace space(testing::wall_with_door());
    double cost = std::numeric_limits<double>::infinity();
    Rng rng(3);
    RrtStarOptions options;
    options.nodes = 1500;
    const auto result = rrt_star(space, {start, goal}, options, {}, rng, [&](const Progress& p) {
        EXPECT_LE(p.cost, cost);
        cost = p.cost;
    });
    EXPECT_NEAR(length(space, result.path), cost, 1e-9);
}

TEST(RrtStar, EndsAtOnceWhereNothingIsShorter) {
    PointSpace space({});
    Rng rng(1);
    const SearchResult result = rrt_star(space, {start, goal}, {}, {}, rng);
    EXPECT_EQ(result.path, (Configurations{0.1, 0.1, 0.9, 0.1}));
    EXPECT_EQ(result.iterations, 0U);
}

TEST(RrtStar, MinGammaOfTheUnitSquare) {
    PointSpace space({});
    EXPECT_NEAR(min_gamma(space), 2 * std::sqrt(1.5) / std::sqrt(std::numbers::pi), 1e-12);
}

TEST(RrtStar, VolumesOfTheUnitBall) {
    constexpr double pi = std::numbers::pi;
    const double volumes[] = {1, 2, pi, 4 * pi / 3, pi * pi / 2, 8 * pi * pi / 15};
    for (std::size_t d = 0; d < std::size(volumes); ++d)
        EXPECT_NEAR(log_unit_ball(d), std::log(volumes[d]), 1e-14) << d;
}

}  // namespace
}  // namespace asv::core
