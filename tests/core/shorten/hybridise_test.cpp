#include "core/shorten/hybridise.hpp"

#include <gtest/gtest.h>

#include "core/space/chain_world.hpp"
#include "core/space/motion_cost.hpp"
#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/chains/problems.hpp"

namespace asv::core {
namespace {

using test::nth;

/// Bridges that are straight, in a plane without obstacles.
bool straight_bridge(std::span<const double>, std::span<const double> to, Configurations& between) {
    between.assign(to.begin(), to.end());
    return true;
}

TEST(Hybridise, TakesTheBetterHalfOfEach) {
    const ChainWorld world(test::problem({{0.1, 0.5}}, {{0.9, 0.5}}), Anchor::centroid);
    const Configurations first_half_good{0.1, 0.5, 0.5, 0.5, 0.7, 0.9, 0.9, 0.5};
    const Configurations last_half_good{0.1, 0.5, 0.3, 0.1, 0.5, 0.5, 0.9, 0.5};
    MotionCost cost(world.chain);
    for (const bool swapped : {false, true}) {
        const Configurations best = hybridise(swapped ? last_half_good : first_half_good,
                                              swapped ? first_half_good : last_half_good,
                                              world.metric, cost, straight_bridge);
        EXPECT_NEAR(cost.path(best), 0.8, 1e-12);
        EXPECT_EQ(nth(best, 2, 0)[0], 0.1);
        EXPECT_EQ(best[best.size() - 2], 0.9);
    }
}

TEST(Hybridise, WithoutBridgesOrWithAnotherGoalThePathStays) {
    const ChainWorld world(test::problem({{0.1, 0.5}}, {{0.9, 0.5}}), Anchor::centroid);
    const Configurations path{0.1, 0.5, 0.4, 0.6, 0.9, 0.5}, other{0.1, 0.5, 0.4, 0.9, 0.9, 0.5};
    MotionCost cost(world.chain);
    const Bridge none = [](auto, auto, Configurations&) { return false; };
    EXPECT_NEAR(cost.path(hybridise(path, other, world.metric, cost, none)), cost.path(path),
                1e-12);
    const Configurations elsewhere{0.1, 0.5, 0.2, 0.5};
    EXPECT_EQ(hybridise(path, elsewhere, world.metric, cost, straight_bridge), path);
}

}  // namespace
}  // namespace asv::core
