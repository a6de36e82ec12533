#include "core/shorten/improve.hpp"

#include <stop_token>

#include "core/space/motion_cost.hpp"
#include "tests/kit/configuration_oracle.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/wandering_path.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::Oracle;
using test::scaled;
using test::Wanderer;

TEST(Improve, CostNeverGrowsAndThePathStaysValid) {
    std::size_t gains = 0;
    for_seeds(scaled(15), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 7, 15};
        Wanderer wanderer(rng, sizes[rng.below(4)], 4);
        double last = MotionCost(wanderer.world.chain).path(wanderer.path);
        const Configurations better =
            improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                    2e5, {}, rng, [&](double found) {
                        EXPECT_LT(found, last);
                        last = found;
                        ++gains;
                    });
        EXPECT_NEAR(MotionCost(wanderer.world.chain).path(better), last, 1e-9);
        wanderer.expect_same_ends(better);
        Oracle(wanderer.world).expect_valid_path(better);
    });
    EXPECT_GE(gains, 10U);
}

TEST(Improve, SameSeedSamePath) {
    const auto improved = [](std::uint64_t seed) {
        Rng made(3), rng(seed);
        Wanderer wanderer(made, 7, 4);
        return improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering,
                       {}, 1e5, {}, rng);
    };
    EXPECT_EQ(improved(1), improved(1));
    EXPECT_NE(improved(1), improved(2));
}

TEST(Improve, EndsWhenItHasTo) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    EXPECT_EQ(improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                      0, {}, rng),
              wanderer.path);
    Limits expired;
    expired.deadline = Clock::now();
    EXPECT_EQ(improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                      1e9, expired, rng),
              wanderer.path);
    std::stop_source source;
    Limits stopped;
    stopped.stop = source.get_token();
    source.request_stop();
    EXPECT_EQ(improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                      1e9, stopped, rng),
              wanderer.path);
}

TEST(Improve, SearchesThatCountNothingComeToAnEnd) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    std::size_t searches = 0;
    const auto another = [&](Rng&) {
        ++searches;
        return AnotherPath{wanderer.path, 0};
    };
    const Configurations still(
        wanderer.path.begin(),
        wanderer.path.begin() + static_cast<std::ptrdiff_t>(wanderer.world.chain.dimension()));
    improve(still, wanderer.checker, wanderer.world.metric, wanderer.steering, another, 1e4, {},
            rng);
    EXPECT_EQ(searches, 0U) << "nothing is shorter than no way at all";
    improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, another, 1e4,
            {}, rng);
    EXPECT_LE(searches, 1000U);
}

TEST(Improve, APathThatStaysWhereItIs) {
    Rng rng(1);
    Wanderer wanderer(rng, 3, 0);
    EXPECT_EQ(improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                      1e4, {}, rng),
              wanderer.path);
    Configurations twice(wanderer.path);
    twice.insert(twice.end(), wanderer.path.begin(), wanderer.path.end());
    EXPECT_EQ(improve(twice, wanderer.checker, wanderer.world.metric, wanderer.steering, {}, 1e4,
                      {}, rng),
              twice);
}

}  // namespace
}  // namespace asv::core
