#include "core/shorten/band/elastic_band.hpp"

#include <cmath>

#include "core/space/motion_cost.hpp"
#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/wandering_path.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::Oracle;
using test::Points;
using test::ring;
using test::Row;
using test::scaled;
using test::Wanderer;

bool never() {
    return false;
}

TEST(ElasticBand, GainsAndKeepsEndsAndValidity) {
    double before = 0, after = 0;
    for_seeds(scaled(30), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 5, 7, 15};
        const std::size_t n = sizes[rng.below(5)];
        Wanderer made(rng, test::cluttered(rng, n, 25, 0.1), 3);
        const std::size_t d = made.world.chain.dimension();
        MotionCost cost(made.world.chain);
        ElasticBand band(made.checker, made.world.metric);
        band.take(made.path, 0.04);
        double now = cost.path(made.path);
        before += now;
        for (int i = 0; i < 4; ++i) {
            const double gained = band.tighten(never);
            ASSERT_GE(gained, 0);
            const Configurations path = band.path();
            Oracle(made.world).expect_valid_path(path, 20);
            ASSERT_LE(cost.path(path), (now - gained) * (1 + 1e-6));
            now = cost.path(path);
            for (std::size_t k = 0; k < d; ++k) {
                ASSERT_EQ(path[k], made.path[k]);
                ASSERT_EQ(path[path.size() - d + k], made.path[made.path.size() - d + k]);
            }
        }
        after += now;
    });
    EXPECT_LT(after, 0.8 * before);
}

TEST(ElasticBand, WithoutObstaclesAllGoStraight) {
    for_seeds(scaled(10), [](Rng& rng) {
        const Points start = ring(7, {0.25, 0.3}, 1);
        Points goal = test::moved(start, 0.5, 0.3);
        const ChainWorld world(test::problem(start, goal), Anchor::centroid);
        MotionChecker checker = world.make_checker();
        SlideSteering steering(checker, world.metric, {});
        Row aside(world.start);
        aside[0] = rng.uniform(0.3, 0.7);
        aside[1] = rng.uniform(0.3, 0.7);
        Configurations rows(world.start);
        ASSERT_EQ(steering.slide(world.start, aside, rows), Steered::reached);
        ASSERT_EQ(steering.slide(aside, world.goal, rows), Steered::reached);
        ElasticBand band(checker, world.metric);
        band.take(rows, 0.05);
        for (int i = 0; i < 20; ++i) band.tighten(never);
        EXPECT_NEAR(MotionCost(world.chain).path(band.path()), 7 * std::hypot(0.5, 0.3), 1e-3);
    });
}

TEST(ElasticBand, StopsWhenToldAndLeavesThePath) {
    Rng rng(3);
    Wanderer made(rng, test::cluttered(rng, 7, 25, 0.1), 3);
    ElasticBand band(made.checker, made.world.metric);
    band.take(made.path, 0.05);
    const Configurations untouched = band.path();
    band.take(made.path, 0.05);
    EXPECT_EQ(band.tighten([] { return true; }), 0);
    EXPECT_EQ(band.path(), untouched);
}

}  // namespace
}  // namespace asv::core
