#include "core/space/slide_space.hpp"

#include <cmath>

#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::Points;
using test::ring;
using test::Row;

double off(Point a, Point b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

TEST(SlideSpace, TheGuideIsTheShortestWayOfTheAsvInTheMiddle) {
    Problem problem = test::problem(ring(5, {0.2, 0.2}, 0), ring(5, {0.8, 0.2}, 0));
    problem.obstacles = {{{0.45, 0}, {0.55, 0.6}}};
    const ChainWorld world(problem, Anchor::centroid);
    const auto stops = SlideSpace(world, {}).guide();
    ASSERT_GE(stops.size(), 2U);
    EXPECT_EQ(stops.front(), world.problem.start[2]);
    EXPECT_LT(off(stops.back(), world.problem.goal[2]), 1e-12);
    double highest = 0;
    for (std::size_t i = 1; i < stops.size(); ++i) {
        EXPECT_LE(off(stops[i - 1], stops[i]), 0.05 + 1e-12);
        highest = std::max(highest, stops[i].y);
    }
    // Over the wall, which the tolerance makes a little lower.
    EXPECT_NEAR(highest, 0.6, 2 * problem.requirements.tolerance);
}

TEST(SlideSpace, AnAsvThatEndsWhereItStartsHasAGuideAllTheSame) {
    Points start = ring(5, {0.5, 0.5}, 0), goal = ring(5, {0.5, 0.5}, 2);
    goal = test::moved(goal, start[2].x - goal[2].x, start[2].y - goal[2].y);
    goal[2] = start[2];
    const ChainWorld world(test::problem(start, goal), Anchor::centroid);
    const auto stops = SlideSpace(world, {}).guide();
    ASSERT_FALSE(stops.empty());
    for (const Point& stop : stops) EXPECT_EQ(stop, world.problem.start[2]);
}

TEST(SlideSpace, SamplesNearAPointAreValidAndNear) {
    const Problem problem = test::problem(ring(5, {0.2, 0.2}, 0), ring(5, {0.8, 0.2}, 0));
    const ChainWorld world(problem, Anchor::centroid);
    SlideSpace space(world, {});
    std::size_t found = 0;
    test::for_seeds(100, [&](Rng& rng) {
        Row row(world.chain.dimension());
        if (!space.sample_near(rng, {0.5, 0.6}, row)) return;
        ++found;
        ASSERT_TRUE(space.checker().valid(row));
        ASSERT_LT(off(space.position(row, 2), {0.5, 0.6}), 0.2);
    });
    EXPECT_GE(found, 90U);
}

}  // namespace
}  // namespace asv::core
