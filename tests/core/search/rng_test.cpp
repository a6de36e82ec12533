#include "core/search/rng.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace asv::core {
namespace {

// Golden numbers of the published algorithms: splitmix64 of seed 0, xoshiro256** over it.
TEST(Rng, SameNumbersOnEveryMachine) {
    Rng rng(0);
    EXPECT_EQ(rng.bits(), 0x99ec5f36cb75f2b4U);
    EXPECT_EQ(rng.bits(), 0xbf6e1f784956452aU);
    EXPECT_EQ(rng.bits(), 0x1a5f849d4933e6e0U);
}

struct Moments {
    double mean = 0, variance = 0;
};

template <class Draw>
Moments moments(Draw&& draw) {
    constexpr int count = 200000;
    double sum = 0, squares = 0;
    for (int i = 0; i < count; ++i) {
        const double value = draw();
        sum += value;
        squares += value * value;
    }
    const double mean = sum / count;
    return {mean, squares / count - mean * mean};
}

TEST(Rng, DrawsHaveTheMomentsOfTheirLaws) {
    Rng rng(7);
    const Moments uniform = moments([&] { return rng.uniform(2, 5); });
    EXPECT_NEAR(uniform.mean, 3.5, 0.02);
    EXPECT_NEAR(uniform.variance, 0.75, 0.02);
    const Moments normal = moments([&] { return rng.normal(); });
    EXPECT_NEAR(normal.mean, 0, 0.02);
    EXPECT_NEAR(normal.variance, 1, 0.02);
    for (const double shape : {0.3, 1.0, 5.0}) {
        const Moments gamma = moments([&] { return rng.gamma(shape); });
        EXPECT_NEAR(gamma.mean, shape, 0.02 * (1 + shape));
        EXPECT_NEAR(gamma.variance, shape, 0.04 * (1 + shape));
    }
    const Moments chance = moments([&] { return rng.chance(0.3) ? 1.0 : 0.0; });
    EXPECT_NEAR(chance.mean, 0.3, 0.01);
}

TEST(Rng, BelowReachesEveryNumberAndNoOther) {
    Rng rng(3);
    std::vector<int> seen(7);
    for (int i = 0; i < 7000; ++i) ++seen.at(rng.below(7));
    for (const int times : seen) EXPECT_NEAR(times, 1000, 150);
}

}  // namespace
}  // namespace asv::core
