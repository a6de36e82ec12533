#include "core/shorten/improve.hpp"

#include <cmath>
#include <stop_token>
#include <vector>

#include "core/shorten/chain_shortener.hpp"
#include "core/space/motion_cost.hpp"
#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/chains/wandering_path.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::Oracle;
using test::scaled;
using test::Wanderer;

/// A path in the wanderer's world, improved.
Configurations improved(Wanderer& wanderer, const Configurations& path,
                        const ImproveOptions& options, Rng& rng) {
    ChainShortener shortener(wanderer.checker, wanderer.world.metric, wanderer.steering);
    return improve(path, shortener, options, rng);
}

TEST(Improve, CostNeverGrowsAndThePathStaysValid) {
    std::size_t gains = 0;
    for_seeds(scaled(15), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 7, 15};
        Wanderer wanderer(rng, sizes[rng.below(4)], 4);
        double last = MotionCost(wanderer.world.chain).path(wanderer.path);
        const auto on_better = [&](double found) {
            EXPECT_LT(found, last);
            last = found;
            ++gains;
        };
        const Configurations better =
            improved(wanderer, wanderer.path, {.work = 2e5, .on_better = on_better}, rng);
        EXPECT_NEAR(MotionCost(wanderer.world.chain).path(better), last, 1e-9);
        wanderer.expect_same_ends(better);
        Oracle(wanderer.world).expect_valid_path(better);
    });
    EXPECT_GE(gains, 10U);
}

TEST(Improve, SameSeedSamePath) {
    const auto with_seed = [](std::uint64_t seed) {
        Rng made(3), rng(seed);
        Wanderer wanderer(made, 7, 4);
        return improved(wanderer, wanderer.path, {.work = 1e5}, rng);
    };
    EXPECT_EQ(with_seed(1), with_seed(1));
    EXPECT_NE(with_seed(1), with_seed(2));
}

TEST(Improve, EndsWhenItHasTo) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    EXPECT_EQ(improved(wanderer, wanderer.path, {.work = 0}, rng), wanderer.path);
    Limits expired;
    expired.deadline = Clock::now();
    EXPECT_EQ(improved(wanderer, wanderer.path, {.work = 1e9, .limits = expired}, rng),
              wanderer.path);
    std::stop_source source;
    Limits stopped;
    stopped.stop = source.get_token();
    source.request_stop();
    EXPECT_EQ(improved(wanderer, wanderer.path, {.work = 1e9, .limits = stopped}, rng),
              wanderer.path);
}

TEST(Improve, APathThatIsGoodEnoughStaysAsItIs) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    const double cost = MotionCost(wanderer.world.chain).path(wanderer.path);
    EXPECT_EQ(improved(wanderer, wanderer.path, {.good_enough = cost}, rng), wanderer.path);
}

TEST(Improve, AShorterPathOfAnotherSearchIsTaken) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    const Configurations shorter = improved(wanderer, wanderer.path, {.work = 1e6}, rng);
    int searches = 0;
    const auto another = [&](Rng&, double) {
        return ++searches == 1 ? AnotherPath{shorter, 0} : AnotherPath{};
    };
    MotionCost cost(wanderer.world.chain);
    const Configurations best =
        improved(wanderer, wanderer.path, {.work = 1e5, .another = another}, rng);
    EXPECT_GE(searches, 1);
    EXPECT_LE(cost.path(best), cost.path(shorter));
}

TEST(Improve, SearchesThatFailGetMoreTimeUntilTheWorkIsSpent) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    std::vector<double> patience;
    const auto another = [&](Rng&, double longer) {
        patience.push_back(longer);
        return AnotherPath{{}, 1e3 * longer};
    };
    ChainShortener shortener(wanderer.checker, wanderer.world.metric, wanderer.steering);
    const double work = 1e6, before = shortener.work();
    improve(wanderer.path, shortener, {.work = work, .another = another}, rng);
    ASSERT_GT(patience.size(), 20U);
    double spent = shortener.work() - before;
    for (std::size_t i = 0; i < patience.size(); ++i) {
        EXPECT_EQ(patience[i], std::exp2(i / 5)) << "search " << i;
        EXPECT_LT(spent, work) << "search " << i;
        spent += 1e3 * patience[i];
    }
    EXPECT_GE(spent, work) << "it gave up with work left";
}

TEST(Improve, SearchesThatCountNothingComeToAnEnd) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    std::size_t searches = 0;
    const auto another = [&](Rng&, double) {
        ++searches;
        return AnotherPath{wanderer.path, 0};
    };
    const ImproveOptions options{.work = 1e4, .another = another};
    const Configurations still(
        wanderer.path.begin(),
        wanderer.path.begin() + static_cast<std::ptrdiff_t>(wanderer.world.chain.dimension()));
    improved(wanderer, still, options, rng);
    EXPECT_EQ(searches, 0U) << "nothing is shorter than no way at all";
    improved(wanderer, wanderer.path, options, rng);
    EXPECT_LE(searches, 1000U);
}

TEST(Improve, APathThatStaysWhereItIs) {
    Rng rng(1);
    Wanderer wanderer(rng, 3, 0);
    EXPECT_EQ(improved(wanderer, wanderer.path, {.work = 1e4}, rng), wanderer.path);
    Configurations twice(wanderer.path);
    twice.insert(twice.end(), wanderer.path.begin(), wanderer.path.end());
    EXPECT_EQ(improved(wanderer, twice, {.work = 1e4}, rng), twice);
}

}  // namespace
}  // namespace asv::core
