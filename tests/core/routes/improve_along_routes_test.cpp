#include "core/routes/improve_along_routes.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/space/motion_cost.hpp"
#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/two_doors.hpp"
#include "tests/kit/chains/wandering_path.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

/// A path in the wanderer's world, improved along the routes to where it ends.
Configurations improved(test::Wanderer& wanderer, const Configurations& path,
                        const ImproveOptions& options, Rng& rng) {
    RouteSearchOptions search;
    search.limits = options.limits;
    search.limits.max_iterations = 1000;
    RouteSearch routes(wanderer.world, search);
    ChainShortener shortener(wanderer.checker, wanderer.world.metric, wanderer.steering);
    return improve_along_routes(path, wanderer.world, shortener, routes, options, rng);
}

/// Some path from the start to the goal of the wanderer's problem.
Configurations path_to_goal(const test::Wanderer& wanderer, Leader leader, Rng& rng) {
    RouteSearchOptions search;
    search.limits.max_iterations = 3000;
    RouteSearch routes(wanderer.world, search);
    return routes.search_between({wanderer.world.start, wanderer.world.goal}, leader, rng).path;
}

TEST(ImproveAlongRoutes, CostNeverGrowsAndThePathStaysValid) {
    test::for_seeds(test::scaled(6), [](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 7};
        test::Wanderer wanderer(rng, test::cluttered(rng, sizes[rng.below(3)], 5, 0.2), 0);
        const Configurations path = path_to_goal(wanderer, Leader::either, rng);
        if (path.empty()) return;
        double last = MotionCost(wanderer.world.chain).path(path);
        const auto on_better = [&](double found) {
            EXPECT_LT(found, last);
            last = found;
        };
        const Configurations better =
            improved(wanderer, path, {.work = 3e5, .on_better = on_better}, rng);
        EXPECT_NEAR(MotionCost(wanderer.world.chain).path(better), last, 1e-9);
        const auto d = static_cast<std::ptrdiff_t>(wanderer.world.chain.dimension());
        EXPECT_EQ(Configurations(better.begin(), better.begin() + d), wanderer.world.start);
        test::Oracle(wanderer.world).expect_valid_path(better);
    });
}

TEST(ImproveAlongRoutes, SameSeedSamePath) {
    const auto with_seed = [](std::uint64_t seed) {
        Rng made(3), rng(seed);
        test::Wanderer wanderer(made, test::two_doors(), 0);
        const Configurations path = path_to_goal(wanderer, Leader::either, made);
        return improved(wanderer, path, {.work = 1e5}, rng);
    };
    EXPECT_EQ(with_seed(1), with_seed(1));
    EXPECT_NE(with_seed(1), with_seed(2));
}

TEST(ImproveAlongRoutes, FindsTheNearDoorFromAPathThroughTheFarOne) {
    Rng rng(1);
    test::Wanderer wanderer(rng, test::two_doors(), 0);
    Problem closed = wanderer.world.problem;
    closed.obstacles.push_back(test::near_door);
    test::Wanderer round(rng, closed, 0);
    const Configurations path = path_to_goal(round, Leader::either, rng);
    ASSERT_FALSE(path.empty());
    MotionCost cost(wanderer.world.chain);
    const double best_of_round = cost.path(improved(round, path, {.work = 2e5}, rng));
    EXPECT_LT(cost.path(improved(wanderer, path, {.work = 2e5}, rng)), 0.9 * best_of_round);
}

TEST(ImproveAlongRoutes, EndsWhenItHasTo) {
    Rng rng(3);
    test::Wanderer wanderer(rng, test::two_doors(), 0);
    const Configurations path = path_to_goal(wanderer, Leader::either, rng);
    ImproveOptions options{.work = 1e12};
    options.limits.deadline = Clock::now();
    EXPECT_EQ(improved(wanderer, path, options, rng), path);
}

}  // namespace
}  // namespace asv::core
