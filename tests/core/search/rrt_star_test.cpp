#include "core/search/rrt_star.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
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
    test::for_seeds(test::scaled(20), [](Rng& rng) {
        PointSpace space(test::wall_with_door());
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
        test::for_seeds(5, [&](Rng& rng) {
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
    PointSpace space(test::wall_with_door());
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
